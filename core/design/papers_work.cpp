// SPDX-License-Identifier: MIT
#include "core/design/papers_work.h"

#include "core/base/parallel.h"
#include "core/design/prt_bench_room.h"
#include "core/glossy/transfer_matrix.h"
#include "core/glossy/visibility.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"
#include "core/prt/direct_transfer.h"
#include "core/prt/shadow_pass.h"
#include "core/prt/texture_receivers.h"
#include "core/prt/vertex_receivers.h"
#include "core/sh/analytic_light.h"
#include "core/sh/cube_map.h"
#include "core/sh/triple_product.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace soffit::design {
namespace {

constexpr std::size_t kCoefficients = sh::coefficientCount(kPapersBands);
constexpr int kWideBands = 2 * kPapersBands - 1;
/// The smoothest surface but one that 5 bands serve (glossy/bands.h: 0.40).
constexpr float kAlpha = 0.5F;

class Watch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The room's shell is 9 flat pieces of 2 cells^2 triangles; its block and sphere stay as they are.
int cellsFor(std::size_t triangles) {
  constexpr double kPieces = 9.0, kOthers = 540.0;
  const double wanted = std::max(static_cast<double>(triangles) - kOthers, 0.0);
  return std::max(1, static_cast<int>(std::lround(std::sqrt(wanted / (2.0 * kPieces)))));
}

/// Projects what `receivers` see on `bands`.
glossy::FloatBlocks project(const glossy::VisibilityBits& bits, const sh::SphereSamples& samples,
                            int bands) {
  const std::size_t count = sh::coefficientCount(bands);
  std::vector<float> weighted(samples.size() * count);
  std::array<double, sh::kMaxCoefficients> basis;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    sh::evaluate(samples.directions[k], bands, basis);
    for (std::size_t i = 0; i < count; ++i) {
      weighted[k * count + i] = static_cast<float>(samples.weights[k] * basis[i]);
    }
  }
  glossy::FloatBlocks out(bits.receivers(), count);
  parallelFor(bits.receivers(), 16 * glossy::kBlock, [&](std::size_t begin, std::size_t end) {
    std::vector<float> sum(count);
    for (std::size_t r = begin; r < end; ++r) {
      std::fill(sum.begin(), sum.end(), 0.0F);
      for (std::size_t k = 0; k < samples.size(); ++k) {
        if (!bits.open(r, k)) continue;
        for (std::size_t i = 0; i < count; ++i) sum[i] += weighted[k * count + i];
      }
      for (std::size_t i = 0; i < count; ++i) out.at(r, i) = sum[i];
    }
  });
  return out;
}

glossy::VisibilityBits lookAround(const prt::Surfaces& surfaces, const prt::Receivers& receivers,
                                  const sh::SphereSamples& samples) {
  return glossy::lookAround(*surfaces.caster, receivers.positions, receivers.facing, samples);
}

}  // namespace

CubeLight::CubeLight(int side) : table_(sh::cubeSamples(side), kPapersBands) {
  const sh::AnalyticLight light{.scale = 1000.0};
  for (const dvec3& d : sh::cubeSamples(side).directions) {
    const double value = light(d);
    const std::array<double, 3> rgb{value, 0.9 * value + 20.0, 0.7 * value + 50.0};
    for (std::size_t c = 0; c < 3; ++c) radiance_[c].push_back(static_cast<float>(rgb[c]));
  }
}

sh::RgbCoefficients CubeLight::project() const {
  return table_.project(radiance_[0], radiance_[1], radiance_[2]);
}

double CubeLight::work() const {
  return 3.0 * static_cast<double>(table_.sampleCount() * kCoefficients);
}

PapersPlace verticesPlace(std::size_t triangles, int directions) {
  const auto surfaces = prtBenchRoom(cellsFor(triangles));
  const Watch watch;
  const prt::VertexReceivers set(surfaces);
  PapersPlace place;
  place.name = "vertices";
  place.triangles = surfaces->triangleCount();
  place.receivers = set.receivers();
  const sh::SphereSamples samples = sh::hammersleySamples(directions);
  const glossy::VisibilityBits bits = lookAround(*surfaces, place.receivers, samples);
  place.visibility = project(bits, samples, kPapersBands);
  place.bake_s = watch.seconds();
  place.wide = project(bits, samples, kWideBands);
  const prt::Directions flagged(samples, kPapersBands);
  const auto shadows = prt::traceShadows(*surfaces, place.receivers, flagged).value();
  place.diffuse =
      prt::TransferVectors(prt::shadowedTransfer(place.receivers, flagged, shadows.flags).value());
  return place;
}

PapersPlace texturePlace(std::size_t triangles, int side, int directions) {
  const auto surfaces = prtBenchRoom(cellsFor(triangles));
  const Watch watch;
  prt::TextureOptions options;
  options.side = side;
  PapersPlace place;
  place.name = fmt::format("texture {}", side);
  place.triangles = surfaces->triangleCount();
  place.receivers = prt::TextureReceivers::atlas(surfaces, options).receivers();
  const sh::SphereSamples samples = sh::hammersleySamples(directions);
  place.visibility =
      project(lookAround(*surfaces, place.receivers, samples), samples, kPapersBands);
  place.bake_s = watch.seconds();
  return place;
}

std::vector<glossy::LobeView> papersLobes(const prt::Receivers& receivers, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<glossy::LobeView> lobes(receivers.size());
  for (std::size_t i = 0; i < lobes.size(); ++i) {
    const float u = rng.uniform();
    const vec3 axis = uniformSphere(u, rng.uniform());
    lobes[i].axis = glm::dot(axis, receivers.normals[i]) < 0.0F ? -axis : axis;
    lobes[i].alpha = kAlpha;
  }
  return lobes;
}

namespace {

std::vector<double> rowsOf(const glossy::FloatBlocks& blocks, std::size_t receiver) {
  std::vector<double> rows(blocks.rows());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i] = static_cast<double>(blocks.at(receiver, i));
  }
  return rows;
}

}  // namespace

glossy::MatrixSet papersMatrices(const PapersPlace& place, bool symmetric) {
  glossy::MatrixSet set(place.receivers.size(), kPapersBands, symmetric);
  parallelFor(set.receivers(), 4 * glossy::kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      set.set(r, glossy::matrixFromVisibility(rowsOf(place.wide, r), kPapersBands));
    }
  });
  return set;
}

glossy::VisibilitySet halvesOf(const glossy::FloatBlocks& visibility) {
  glossy::VisibilitySet set(visibility.receivers(), sh::bandsOf(visibility.rows()));
  for (std::size_t r = 0; r < set.receivers(); ++r) set.set(r, rowsOf(visibility, r));
  return set;
}

void multiplyTriple(const sh::RgbCoefficients& light, const glossy::FloatBlocks& visibility,
                    glossy::FloatBlocks& arriving) {
  const auto& tensor = sh::TripleProduct::ofBands(kPapersBands);
  // The batch takes a light per receiver, as it may be: here all have the same.
  std::vector<float> lights;
  for (const sh::Coefficients& channel : light) {
    for (const double c : channel)
      lights.insert(lights.end(), glossy::kBlock, static_cast<float>(c));
  }
  constexpr std::size_t kPlane = kCoefficients * glossy::kBlock;
  parallelFor(visibility.blocks(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      for (std::size_t c = 0; c < 3; ++c) {
        tensor.multiplyBatch(lights.data() + c * kPlane, visibility.block(b),
                             arriving.block(b) + c * kPlane, glossy::kBlock, glossy::kBlock);
      }
    }
  });
}

double tripleWork(int bands) {
  double work = 0.0;
  for (const sh::TripleEntry& e : sh::TripleProduct::ofBands(bands).entries()) {
    work += e.i == e.k ? 1.0 : (e.i == e.j || e.j == e.k ? 3.0 : 6.0);
  }
  return work;
}

std::size_t halvesInBlocks(std::size_t receivers, std::size_t numbers, std::size_t block) {
  return (receivers + block - 1) / block * block * numbers * sizeof(transfer::Half);
}

}  // namespace soffit::design

// SPDX-License-Identifier: MIT
#include "core/base/parallel.h"
#include "core/design/glossy_bench.h"
#include "core/design/sh_bench.h"
#include "core/glossy/clustered_matrices.h"
#include "core/glossy/direction_table.h"
#include "core/glossy/lobe_shape.h"
#include "core/glossy/ltc_light.h"
#include "core/glossy/matrix_set.h"
#include "core/glossy/reflection_map.h"
#include "core/glossy/transfer_matrix.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"
#include "core/sh/cube_map.h"
#include "core/sh/zonal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace soffit::design {
namespace {

using glossy::FloatBlocks;

constexpr int kBands = 5;
constexpr int kWide = 2 * kBands - 1;

vec3 uniformOn(Rng& rng) {
  const float u = rng.uniform();
  return uniformSphere(u, rng.uniform());
}

dvec3 randomDirection(Rng& rng) {
  return dvec3(uniformOn(rng));
}

/// Ground with boxes on it, as a city or a room full of furniture.
geometry::RayCaster boxField(Rng& rng) {
  std::vector<vec3> corners;
  std::vector<uvec3> triangles;
  constexpr int kBoxes = 60;
  for (int b = 0; b < kBoxes; ++b) {
    const vec3 lo(20.0F * rng.uniform(), 20.0F * rng.uniform(), 0.02F);
    const vec3 hi =
        lo + vec3(0.3F + rng.uniform(), 0.3F + rng.uniform(), 0.3F + 1.7F * rng.uniform());
    const auto first = static_cast<std::uint32_t>(corners.size());
    for (unsigned i = 0; i < 8; ++i) {
      corners.emplace_back((i & 1U) != 0 ? hi.x : lo.x, (i & 2U) != 0 ? hi.y : lo.y,
                           (i & 4U) != 0 ? hi.z : lo.z);
    }
    constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
        {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};
    for (const auto& f : kFaces) {
      triangles.emplace_back(first + f[0], first + f[1], first + f[2]);
      triangles.emplace_back(first + f[0], first + f[2], first + f[3]);
    }
  }
  return {corners, triangles};
}

/// What all cases share.
struct Field {
  std::size_t receivers;
  std::vector<float> visibility;  ///< kWide^2 per receiver
  sh::RgbCoefficients light;
  FloatBlocks exact;  ///< what arrives at each receiver
  FloatBlocks arriving;
  std::vector<glossy::LobeView> lobes;
  std::vector<vec3> radiance;

  Field(std::size_t count, std::uint64_t seed)
      : receivers(count),
        visibility(count * sh::coefficientCount(kWide)),
        exact(count, 3 * sh::coefficientCount(kBands)),
        arriving(count, 3 * sh::coefficientCount(kBands)),
        radiance(count) {
    Rng rng(seed);
    const geometry::RayCaster scene = boxField(rng);
    const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    std::vector<vec3> positions;
    for (std::size_t r = 0; r < count; ++r) {
      positions.emplace_back(
          20.0F * (static_cast<float>(r % side) + 0.5F) / static_cast<float>(side),
          20.0F * (static_cast<float>(r / side) + 0.5F) / static_cast<float>(side), 0.0F);
    }
    const std::vector<vec3> up(count, vec3(0, 0, 1));
    const sh::SphereSamples samples = sh::hammersleySamples(400);
    const glossy::VisibilityBits bits = glossy::lookAround(scene, positions, up, samples);
    // A sun, as wide as a hand, and a sky.
    const auto sun =
        sh::zonalAbout(sh::capKernel(0.2, kBands), glm::normalize(dvec3(0.5, 0.3, 0.7)));
    for (std::size_t c = 0; c < 3; ++c) {
      light[c] = sh::Coefficients(sh::coefficientCount(kBands), 0.0);
      for (std::size_t i = 0; i < light[c].size(); ++i) light[c][i] = 20.0 * sun[i];
      light[c][0] += 1.0 + 0.3 * static_cast<double>(c);
    }
    parallelFor(count, 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) {
        const auto v = glossy::visibilityCoefficients(bits, r, samples, kWide);
        std::copy(v.begin(), v.end(),
                  visibility.begin() + static_cast<std::ptrdiff_t>(r * v.size()));
        const auto matrix = glossy::matrixFromVisibility(v, kBands);
        for (std::size_t k = 0; k < exact.rows(); ++k) {
          const std::size_t n = light[0].size();
          double sum = 0.0;
          for (std::size_t j = 0; j < n; ++j) sum += matrix[k % n * n + j] * light[k / n][j];
          exact.at(r, k) = static_cast<float>(sum);
        }
      }
    });
    for (std::size_t r = 0; r < count; ++r) {
      dvec3 axis = randomDirection(rng);
      axis.z = std::abs(axis.z);
      lobes.push_back({vec3(axis), 0.2F + 0.5F * rng.uniform(), 1.0F});
    }
  }
  [[nodiscard]] sh::Coefficients visibilityOf(std::size_t r, int bands) const {
    const auto first =
        visibility.begin() + static_cast<std::ptrdiff_t>(r * sh::coefficientCount(kWide));
    return {first, first + static_cast<std::ptrdiff_t>(sh::coefficientCount(bands))};
  }
  /// RMS error of what arrives, as a share of the RMS of what should.
  template <class SlotOf>
  [[nodiscard]] double errorOf(const FloatBlocks& found, const SlotOf& slot_of) const {
    double error = 0.0, size = 0.0;
    for (std::size_t r = 0; r < receivers; ++r) {
      for (std::size_t k = 0; k < exact.rows(); ++k) {
        const auto should = static_cast<double>(exact.at(r, k));
        const double off = static_cast<double>(found.at(slot_of(r), k)) - should;
        error += off * off;
        size += should * should;
      }
    }
    return std::sqrt(error / size);
  }
  [[nodiscard]] double errorOf(const FloatBlocks& found) const {
    return errorOf(found, [](std::size_t r) { return r; });
  }
};

using SharedField = std::shared_ptr<Field>;

void addMatrices(const SharedField& field, std::vector<GlossyBenchCase>& cases) {
  for (const bool symmetric : {false, true}) {
    auto set = std::make_shared<glossy::MatrixSet>(field->receivers, kBands, symmetric);
    parallelFor(field->receivers, 64 * glossy::kBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) {
        set->set(r, glossy::matrixFromVisibility(field->visibilityOf(r, kWide), kBands));
      }
    });
    cases.push_back({"matrices", symmetric ? "25 x 25, upper triangle" : "25 x 25, all elements",
                     kBands, field->receivers, set->bytes(),
                     [=] { set->apply(field->light, field->arriving); },
                     [=] { return field->errorOf(field->arriving); }});
  }
  for (const int bands : {kWide, kBands}) {
    auto set = std::make_shared<glossy::VisibilitySet>(field->receivers, bands);
    for (std::size_t r = 0; r < field->receivers; ++r) set->set(r, field->visibilityOf(r, bands));
    cases.push_back({"matrices", fmt::format("fixed light, {} of visibility", bands * bands),
                     kBands, field->receivers, set->bytes(),
                     [=] { set->apply(field->light, field->arriving); },
                     [=] { return field->errorOf(field->arriving); }});
  }
}

/// Dhawal et al.'s triple product: light, visibility of the same bands, a product each.
void addTripleProduct(const SharedField& field, std::vector<GlossyBenchCase>& cases) {
  const std::size_t n = sh::coefficientCount(kBands);
  struct Planes {
    std::vector<float> light, visibility, product;
  };
  auto planes = std::make_shared<Planes>();
  const std::size_t count = field->receivers;
  planes->visibility.resize(n * count);
  planes->light.resize(3 * n * count);
  planes->product.resize(3 * n * count);
  for (std::size_t r = 0; r < count; ++r) {
    const auto v = field->visibilityOf(r, kBands);
    for (std::size_t i = 0; i < n; ++i) {
      planes->visibility[i * count + r] = static_cast<float>(v[i]);
      for (std::size_t c = 0; c < 3; ++c) {
        planes->light[(c * n + i) * count + r] = static_cast<float>(field->light[c][i]);
      }
    }
  }
  const auto& tensor = sh::TripleProduct::ofBands(kBands);
  cases.push_back(
      {"matrices", "triple product, 25 of visibility", kBands, count,
       planes->visibility.size() * sizeof(float),
       [=, &tensor] {
         // One thread, channel after channel, as one GPU pixel would.
         for (std::size_t c = 0; c < 3; ++c) {
           tensor.multiplyBatch(planes->light.data() + c * n * count, planes->visibility.data(),
                                planes->product.data() + c * n * count, count, count);
         }
       },
       [=] {
         double error = 0.0, size = 0.0;
         for (std::size_t r = 0; r < count; ++r) {
           for (std::size_t k = 0; k < 3 * n; ++k) {
             const auto should = static_cast<double>(field->exact.at(r, k));
             const double off = static_cast<double>(planes->product[k * count + r]) - should;
             error += off * off;
             size += should * should;
           }
         }
         return std::sqrt(error / size);
       }});
}

void addClusters(const SharedField& field, std::vector<GlossyBenchCase>& cases) {
  struct Setting {
    int clusters, rank;
  };
  for (const Setting s : {Setting{64, 8}, Setting{64, 16}, Setting{256, 16}, Setting{256, 24}}) {
    auto set = std::make_shared<glossy::ClusteredMatrices>(
        field->visibility, kBands, glossy::CpcaOptions{.clusters = s.clusters, .rank = s.rank});
    auto arriving = std::make_shared<FloatBlocks>(set->slots(), field->arriving.rows());
    cases.push_back(
        {"clusters",
         fmt::format("{} clusters, rank {}; predicted {:.4f}, measured {:.4f}", s.clusters, s.rank,
                     set->predictedError(static_cast<std::size_t>(s.rank)), set->measuredError()),
         kBands, field->receivers, set->bytes(), [=] { set->apply(field->light, *arriving); },
         [=] { return field->errorOf(*arriving, [&](std::size_t r) { return set->slotOf(r); }); }});
  }
}

void addShade(const SharedField& field, std::vector<GlossyBenchCase>& cases) {
  cases.push_back(
      {"shade", "lobe per receiver", kBands, field->receivers, field->exact.bytes(),
       [=] { glossy::shade(field->exact, field->lobes, field->radiance); },
       [=] {
         std::vector<double> found, exact;
         const std::size_t n = sh::coefficientCount(kBands);
         for (std::size_t r = 0; r < field->receivers; r += 97) {
           const glossy::LobeView& lobe = field->lobes[r];
           std::vector<double> own;
           for (std::size_t i = 0; i < n; ++i) {
             own.push_back(static_cast<double>(field->exact.at(r, i)));
           }
           exact.push_back(glossy::glossyRadiance(
               own, glossy::lobeKernel(static_cast<double>(lobe.alpha)), dvec3(lobe.axis)));
           found.push_back(static_cast<double>(field->radiance[r].x));
         }
         return relativeRms(found, exact);
       }});
}

void addDirections(const SharedField& field, std::vector<GlossyBenchCase>& cases) {
  constexpr std::size_t kReceivers = 1000;
  const std::size_t count = std::min(kReceivers, field->receivers);
  for (const int side : {8, 16}) {
    auto grid = std::make_shared<glossy::DirectionGrid>(side);
    auto table = std::make_shared<glossy::DirectionTable>(*grid, count, kBands);
    parallelFor(count, 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) {
        table->set(r, glossy::matrixFromVisibility(field->visibilityOf(r, kWide), kBands),
                   glossy::lobeKernel(0.4));
      }
    });
    auto light =
        std::make_shared<std::vector<float>>(field->light[0].begin(), field->light[0].end());
    auto values = std::make_shared<std::vector<double>>(count);
    cases.push_back({"directions", fmt::format("{} nodes, alpha 0.4", grid->size()), kBands, count,
                     table->bytes(),
                     [=] {
                       for (std::size_t r = 0; r < count; ++r) {
                         (*values)[r] = static_cast<double>(
                             table->radiance(r, *light, dvec3(field->lobes[r].axis)));
                       }
                     },
                     [=] {
                       (void)grid;  // the table refers to it
                       std::vector<double> exact;
                       for (std::size_t r = 0; r < count; ++r) {
                         std::vector<double> own;
                         for (std::size_t i = 0; i < 25; ++i) {
                           own.push_back(static_cast<double>(field->exact.at(r, i)));
                         }
                         exact.push_back(glossy::glossyRadiance(own, glossy::lobeKernel(0.4),
                                                                dvec3(field->lobes[r].axis)));
                       }
                       return relativeRms(*values, exact);
                     }});
  }
}

void addHighlight(std::vector<GlossyBenchCase>& cases) {
  const std::vector<dvec3> panel{{-0.5, -0.5, 2}, {-0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}};
  constexpr std::size_t kPoints = 1000;
  auto shares = std::make_shared<std::vector<double>>(kPoints);
  cases.push_back({"highlight", "rectangle by transformed cosines", 0, kPoints, 0,
                   [=] {
                     for (std::size_t k = 0; k < kPoints; ++k) {
                       const double x = -1.0 + 2.0 * static_cast<double>(k) / kPoints;
                       const glossy::LobeFrame frame(
                           {x, 0, 0}, {0, 0, 1}, glm::normalize(dvec3(1.0 - x, 0.2, 1.5)), 0.16);
                       (*shares)[k] = frame.share(panel);
                     }
                   },
                   [] { return 0.0; }});
}

void addMaps(std::vector<GlossyBenchCase>& cases) {
  for (const int side : {32, 64}) {
    const auto levels = std::make_shared<const glossy::ReflectionLevels>(side);
    auto radiance = std::make_shared<std::vector<vec3>>();
    for (const dvec3& d : sh::cubeSamples(side).directions) {
      radiance->emplace_back(d.x > 0.5 ? 4.0F : 0.5F);
    }
    std::size_t bytes = 0;
    for (const auto& level : levels->blurred()) bytes += level.taps() * 8;
    auto map = std::make_shared<glossy::ReflectionMap>(levels, *radiance);
    cases.push_back({"map", fmt::format("blur for all roughnesses, side {}", side), 0,
                     radiance->size(), bytes,
                     [=] { *map = glossy::ReflectionMap(levels, *radiance); }, [] { return 0.0; }});
    constexpr std::size_t kLookups = 10000;
    cases.push_back({"map", fmt::format("lookup, side {}", side), 0, kLookups, 0,
                     [=] {
                       vec3 sum(0.0F);
                       Rng rng(1);
                       for (std::size_t k = 0; k < kLookups; ++k) {
                         sum += map->at(uniformOn(rng), 0.02F + rng.uniform());
                       }
                       (*radiance)[0].x += 0.0F * sum.x;
                     },
                     [] { return 0.0; }});
  }
}

}  // namespace

std::vector<GlossyBenchCase> glossyBenchCases(std::size_t receivers, std::uint64_t seed) {
  const auto field = std::make_shared<Field>(receivers, seed);
  std::vector<GlossyBenchCase> cases;
  addMatrices(field, cases);
  addTripleProduct(field, cases);
  addClusters(field, cases);
  addShade(field, cases);
  addDirections(field, cases);
  addHighlight(cases);
  addMaps(cases);
  return cases;
}

}  // namespace soffit::design

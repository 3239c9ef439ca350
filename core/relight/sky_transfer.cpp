// SPDX-License-Identifier: MIT
#include "core/relight/sky_transfer.h"

#include "core/base/parallel.h"
#include "core/math/quadrature.h"
#include "core/relight/outdoors.h"
#include "core/sh/basis.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace soffit::relight {
namespace {

/// Pieces of the hemisphere's square along its side at which the functions are evaluated: 3 degrees
/// apart, where the sixth band's shortest wave is 60 degrees long.
constexpr int kLook = 32;
/// Quadrature of the coefficients over a hemisphere; a clear sky's corona is 20 degrees wide.
constexpr int kRings = 48;
constexpr int kAround = 192;

double bound(int l) {
  return std::sqrt((2.0 * l + 1.0) / (4.0 * kPi));
}

/// Light of all functions per slot, before it is made positive.
using Responses = std::vector<std::vector<float>>;

}  // namespace

std::vector<EvenHarmonic> evenHarmonics(int bands) {
  std::vector<EvenHarmonic> out;
  for (int l = 0; l < bands; ++l) {
    for (int m = -l; m <= l; m += 2) out.push_back({l, m});
  }
  return out;
}

std::vector<dvec3> evenCoefficients(const daylight::Environment& environment, int bands,
                                    bool upper) {
  const std::vector<EvenHarmonic> functions = evenHarmonics(bands);
  std::vector<dvec3> out(functions.size(), dvec3(0.0));
  std::array<double, sh::kMaxCoefficients> y{};
  const auto add = [&](const dvec3& d, const dvec3& light) {
    sh::evaluate(d, bands, y);
    // Orthonormal on the sphere: twice as much on half of it.
    for (std::size_t k = 0; k < functions.size(); ++k) {
      out[k] += 2.0 * y[sh::index(functions[k].l, functions[k].m)] * light;
    }
  };
  const QuadratureRule rule = gaussLegendre(kRings, 0.0, 1.0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(kRings); ++i) {
    const double z = upper ? rule.nodes[i] : -rule.nodes[i];
    const double r = std::sqrt(1.0 - z * z);
    for (int j = 0; j < kAround; ++j) {
      const double phi = 2.0 * kPi * (j + 0.5) / kAround;
      const dvec3 d(r * std::cos(phi), r * std::sin(phi), z);
      add(d, rule.weights[i] * (2.0 * kPi / kAround) * environment.smoothRadiance(d));
    }
  }
  // A disc is as good as a point to low bands.
  const auto exact = SkyTransfer::exactSpots(environment);
  for (const daylight::Spot& spot : environment.spots()) {
    const bool apart = std::ranges::any_of(
        exact, [&](const daylight::Spot& e) { return e.direction == spot.direction; });
    if (!apart && (spot.direction.z >= 0.0) == upper) add(spot.direction, spot.normal_illuminance);
  }
  return out;
}

std::vector<daylight::Spot> SkyTransfer::exactSpots(const daylight::Environment& environment) {
  std::vector<daylight::Spot> spots = environment.spots();
  const auto flux = [](const daylight::Spot& s) {
    return s.normal_illuminance.x + s.normal_illuminance.y + s.normal_illuminance.z;
  };
  std::ranges::stable_sort(spots, std::ranges::greater(), flux);
  if (spots.size() > kMostSpots) spots.resize(kMostSpots);
  return spots;
}

std::shared_ptr<const SkyTransfer> SkyTransfer::make(const Solver& solver, int bands, bool whole,
                                                     std::span<const float> open, const Job& job) {
  const auto sky = solver.openSky(job);
  if (sky == nullptr) return nullptr;
  std::shared_ptr<SkyTransfer> made(new SkyTransfer(bands, whole));
  const std::vector<EvenHarmonic> functions = evenHarmonics(bands);
  const transfer::Operators& op = solver.operators();
  const std::size_t slots = op.texels.slotCount();
  const std::size_t below = functions.size();  // an even ground needs the first function alone
  const std::size_t count = below + (whole ? below : 1);
  Responses responses(count, std::vector<float>(slots, 0.0F));
  std::atomic<std::size_t> done{0};
  parallelFor(slots, 256, [&](std::size_t begin, std::size_t end) {
    if (job.cancelled()) return;
    std::array<float, sh::kMaxCoefficients> y{};
    std::array<float, 2 * sh::kMaxCoefficients> sum{};
    for (std::size_t s = begin; s < end; ++s) {
      if (op.fill_from[s] != s) continue;
      sum.fill(0.0F);
      sky->forEachDirection(s, kLook, [&](const vec3& d, float weight) {
        const bool up = d.z >= 0.0F;
        if (!up && !whole) {
          sum[below] += weight;
          return;
        }
        sh::evaluate(d, bands, y);
        float* own = &sum[up ? 0 : below];
        own[0] += weight;  // the constant 1
        for (std::size_t k = 1; k < below; ++k) {
          own[k] += weight * y[sh::index(functions[k].l, functions[k].m)];
        }
      });
      for (std::size_t k = 0; k < count; ++k) responses[k][s] = sum[k];
    }
    job.report("light of smooth skies",
               0.5 * static_cast<double>(++done * 256) / static_cast<double>(slots + 256));
  });
  for (std::size_t k = 0; k < count; ++k) {
    if (job.cancelled()) return nullptr;
    Hemisphere& half = k < below ? made->upper_ : made->lower_;
    const std::size_t own = k < below ? k : k - below;
    const std::vector<float>& constant = responses[k < below ? 0 : below];
    const auto least = static_cast<float>(own == 0 ? 0.0 : bound(functions[own].l));
    std::vector<float> direct(slots);
    for (std::size_t s = 0; s < slots; ++s) {
      const std::size_t from = op.fill_from[s];
      direct[s] = std::max(0.0F, responses[k][from] + least * constant[from]);
    }
    half.columns.push_back(columnOf(std::move(direct), op.texels.receivers));
    solver.indirect(half.columns.back(), open);
    job.report("light of smooth skies",
               0.5 + 0.5 * static_cast<double>(k + 1) / static_cast<double>(count));
  }
  return made;
}

void SkyTransfer::addMix(const Hemisphere& from, const std::vector<dvec3>& coefficients,
                         std::vector<WeightedColumn>& out) const {
  const std::vector<EvenHarmonic> functions = evenHarmonics(bands_);
  const std::size_t first = out.size();
  out.push_back({&from.columns[0], coefficients[0] * bound(0)});
  for (std::size_t k = 1; k < from.columns.size(); ++k) {
    out.push_back({&from.columns[k], coefficients[k]});
    out[first].weight -= coefficients[k] * bound(functions[k].l);
  }
}

std::vector<WeightedColumn> SkyTransfer::mix(const daylight::Environment& environment) const {
  std::vector<WeightedColumn> out;
  addMix(upper_, evenCoefficients(environment, bands_, true), out);
  addMix(lower_, evenCoefficients(environment, whole_ ? bands_ : 1, false), out);
  return out;
}

std::vector<dvec3> SkyTransfer::weights(const daylight::Environment& environment) const {
  std::vector<dvec3> out = evenCoefficients(environment, bands_, true);
  std::vector<dvec3> below = evenCoefficients(environment, whole_ ? bands_ : 1, false);
  // y_00 is a constant too, but not 1.
  out[0] *= bound(0);
  below[0] *= bound(0);
  out.insert(out.end(), below.begin(), below.end());
  return out;
}

std::vector<WeightedColumn> SkyTransfer::function(std::size_t k) const {
  const Hemisphere& half = k < upper_.columns.size() ? upper_ : lower_;
  const std::size_t own = k < upper_.columns.size() ? k : k - upper_.columns.size();
  std::vector<WeightedColumn> out{{&half.columns[own], dvec3(1.0)}};
  if (own > 0) out.push_back({&half.columns[0], dvec3(-bound(evenHarmonics(bands_)[own].l))});
  return out;
}

std::size_t SkyTransfer::bytes() const {
  std::size_t sum = 0;
  for (const Hemisphere* half : {&upper_, &lower_}) {
    for (const Column& c : half->columns) {
      sum += c.direct.size() * sizeof(float) + c.lit.size() + c.skeleton.size() * sizeof(vec4) +
             c.node.size() * sizeof(transfer::PatchLight);
    }
  }
  return sum;
}

}  // namespace soffit::relight

// SPDX-License-Identifier: MIT
#include "core/relight/sky_vectors.h"

#include "core/base/parallel.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace soffit::relight {
namespace {

constexpr std::size_t kGrain = 4096;
/// The largest value of the constant function is stored below this; a harmonic's may be 1.1 times
/// as large, and a half holds 65504.
constexpr float kMostStored = 16384.0F;
constexpr float kMostHalf = 65504.0F;

vec3 valueAt(const LightRows& rows, const Planes& lux, std::size_t p) {
  vec3 sum(0.0F);
  for (std::uint32_t k = rows.first[p]; k < rows.first[p + 1]; ++k) {
    const std::uint32_t slot = rows.slots[k];
    sum += rows.weights[k] * vec3(lux[0][slot], lux[1][slot], lux[2][slot]);
  }
  return sum;
}

float greatest(const Planes& lux) {
  float most = 0.0F;
  for (const auto& plane : lux) {
    for (const float v : plane) most = std::max(most, v);
  }
  return most;
}

/// What the values of one group at one point are, four functions' RGB.
using Group = std::array<float, 12>;

}  // namespace

std::shared_ptr<const SkyVectors> SkyVectors::make(std::shared_ptr<const SkyTransfer> transfer,
                                                   const transfer::Operators& operators,
                                                   std::shared_ptr<const LightRows> rows,
                                                   const Job& job) {
  std::shared_ptr<SkyVectors> made(new SkyVectors);
  const std::size_t functions = transfer->functionCount();
  const std::size_t points = rows->points();
  made->groups_ = (functions + kFunctionsPerGroup - 1) / kFunctionsPerGroup;
  std::array<Planes, kFunctionsPerGroup> lux;
  // No function is greater than the constant of its own hemisphere, but for the factor above.
  float most = 0.0F;
  for (const std::size_t constant : {std::size_t{0}, transfer->upperCount()}) {
    spread({}, transfer->function(constant), operators, lux[0], LightPart::share);
    most = std::max(most, greatest(lux[0]));
  }
  if (most > 0.0F) made->scale_ = std::exp2(std::floor(std::log2(kMostStored / most)));
  made->texels_.resize(points * made->texelsPerPoint());
  for (std::size_t g = 0; g < made->groups_; ++g) {
    if (job.cancelled()) return nullptr;
    const std::size_t first = kFunctionsPerGroup * g;
    const std::size_t count = std::min(kFunctionsPerGroup, functions - first);
    for (std::size_t i = 0; i < count; ++i) {
      spread({}, transfer->function(first + i), operators, lux[i], LightPart::share);
    }
    parallelFor(points, kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        Group values{};
        for (std::size_t i = 0; i < count; ++i) {
          const vec3 value =
              glm::clamp(made->scale_ * valueAt(*rows, lux[i], p), -kMostHalf, kMostHalf);
          for (int c = 0; c < 3; ++c) values[3 * i + static_cast<std::size_t>(c)] = value[c];
        }
        std::uint64_t* out = &made->texels_[p * made->texelsPerPoint() + kTexelsPerGroup * g];
        for (std::size_t t = 0; t < kTexelsPerGroup; ++t) {
          const float* v = &values[4 * t];
          out[t] = glm::packHalf4x16(vec4(v[0], v[1], v[2], v[3]));
        }
      }
    });
  }
  made->transfer_ = std::move(transfer);
  made->rows_ = std::move(rows);
  return made;
}

std::vector<vec4> SkyVectors::packed(std::span<const dvec3> weights) const {
  std::vector<vec4> out(texelsPerPoint(), vec4(0.0F));
  for (std::size_t k = 0; k < weights.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = 3 * k + c;
      out[at / 4][static_cast<int>(at % 4)] =
          static_cast<float>(weights[k][static_cast<int>(c)] / static_cast<double>(scale_));
    }
  }
  return out;
}

void SkyVectors::evaluate(std::span<const dvec3> weights, std::span<const vec3> rest,
                          std::span<vec3> out) const {
  const std::vector<vec4> coefficients = packed(weights);
  parallelFor(points(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const std::uint64_t* own = &texels_[p * texelsPerPoint()];
      std::array<vec4, kTexelsPerGroup> sum{};
      for (std::size_t t = 0; t < texelsPerPoint(); ++t) {
        sum[t % kTexelsPerGroup] += coefficients[t] * vec4(glm::unpackHalf4x16(own[t]));
      }
      const vec3 sky(sum[0].x + sum[0].w + sum[1].z + sum[2].y,
                     sum[0].y + sum[1].x + sum[1].w + sum[2].z,
                     sum[0].z + sum[1].y + sum[2].x + sum[2].w);
      out[p] = glm::max(sky + (rest.empty() ? vec3(0.0F) : rest[p]), vec3(0.0F));
    }
  });
}

void lightPoints(const LightRows& rows, const Planes& lux, std::span<vec3> out) {
  parallelFor(rows.points(), 2 * kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      out[p] = valueAt(rows, lux, p);
    }
  });
}

}  // namespace soffit::relight

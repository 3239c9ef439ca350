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

constexpr std::size_t kGrain = 2048;
/// The constant function's light is stored below this; a harmonic's may be 1.1 times as large, and
/// a half holds 65504.
constexpr float kMostStored = 16384.0F;
constexpr float kMostHalf = 65504.0F;

float greatest(const Planes& lux) {
  float most = 0.0F;
  for (const auto& plane : lux) {
    for (const float v : plane) most = std::max(most, v);
  }
  return most;
}

std::uint64_t halves(const vec4& values) {
  return glm::packHalf4x16(glm::clamp(values, -kMostHalf, kMostHalf));
}

}  // namespace

SkyRest skyRest(const Planes& reflected, const Planes& direct) {
  SkyRest out(direct[0].size());
  for (std::size_t s = 0; s < out.size(); ++s) {
    out[s].reflected = {reflected[0][s], reflected[1][s], reflected[2][s]};
    out[s].direct = {direct[0][s], direct[1][s], direct[2][s]};
  }
  return out;
}

void SkyVectors::fill(std::size_t group, const transfer::Operators& operators) {
  std::array<Planes, kFunctionsPerGroup> reflected;
  std::array<Planes, kFunctionsPerGroup> direct;
  const std::size_t first = kFunctionsPerGroup * group;
  const std::size_t count = std::min(kFunctionsPerGroup, transfer_->functionCount() - first);
  for (std::size_t i = 0; i < count; ++i) {
    const auto function = transfer_->function(first + i);
    spread({}, function, operators, reflected[i], LightPart::unbounded);
    spread({}, function, operators, direct[i], LightPart::direct);
  }
  parallelFor(slots(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      std::array<float, 3 * kFunctionsPerGroup> r{};
      vec4 d(0.0F);
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t c = 0; c < 3; ++c) r[3 * i + c] = scale_ * reflected[i][c][s];
        d[static_cast<int>(i)] = scale_ * direct[i][0][s];
      }
      std::uint64_t* out = &texels_[(s * groups_ + group) * kTexelsPerGroup];
      for (std::size_t t = 0; t < 3; ++t) {
        out[t] = halves({r[4 * t], r[4 * t + 1], r[4 * t + 2], r[4 * t + 3]});
      }
      out[3] = halves(d);
    }
  });
}

std::shared_ptr<const SkyVectors> SkyVectors::make(std::shared_ptr<const SkyTransfer> transfer,
                                                   const transfer::Operators& operators,
                                                   const Job& job) {
  std::shared_ptr<SkyVectors> made(new SkyVectors);
  made->transfer_ = std::move(transfer);
  const std::size_t functions = made->transfer_->functionCount();
  made->groups_ = (functions + kFunctionsPerGroup - 1) / kFunctionsPerGroup;
  made->texels_.resize(operators.texels.slotCount() * made->groups_ * kTexelsPerGroup);
  // No function is greater than the constant of its own hemisphere, but for the factor above.
  float most = 0.0F;
  Planes lux;
  for (const std::size_t constant : {std::size_t{0}, made->transfer_->upperCount()}) {
    spread({}, made->transfer_->function(constant), operators, lux);
    most = std::max(most, greatest(lux));
  }
  if (most > 0.0F) made->scale_ = std::exp2(std::floor(std::log2(kMostStored / most)));
  for (std::size_t g = 0; g < made->groups_; ++g) {
    if (job.cancelled()) return nullptr;
    made->fill(g, operators);
  }
  return made;
}

std::vector<vec4> SkyVectors::packed(std::span<const dvec3> weights) const {
  std::vector<vec4> out(kWeightsPerGroup * groups_, vec4(0.0F));
  for (std::size_t k = 0; k < weights.size(); ++k) {
    vec4* own = &out[kWeightsPerGroup * (k / kFunctionsPerGroup)];
    const std::size_t i = k % kFunctionsPerGroup;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto w =
          static_cast<float>(weights[k][static_cast<int>(c)] / static_cast<double>(scale_));
      const std::size_t at = 3 * i + c;
      own[at / 4][static_cast<int>(at % 4)] = w;
      own[3 + c][static_cast<int>(i)] = w;
    }
  }
  return out;
}

Planes SkyVectors::evaluate(std::span<const dvec3> weights, const SkyRest& rest) const {
  const std::vector<vec4> w = packed(weights);
  Planes lux;
  for (auto& plane : lux) plane.resize(slots());
  parallelFor(slots(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      vec4 a(0.0F);
      vec4 b(0.0F);
      vec4 c(0.0F);
      vec3 direct = rest[s].direct;
      for (std::size_t g = 0; g < groups_; ++g) {
        const std::uint64_t* t = &texels_[(s * groups_ + g) * kTexelsPerGroup];
        const vec4* own = &w[kWeightsPerGroup * g];
        a += own[0] * vec4(glm::unpackHalf4x16(t[0]));
        b += own[1] * vec4(glm::unpackHalf4x16(t[1]));
        c += own[2] * vec4(glm::unpackHalf4x16(t[2]));
        const vec4 d(glm::unpackHalf4x16(t[3]));
        direct += vec3(glm::dot(own[3], d), glm::dot(own[4], d), glm::dot(own[5], d));
      }
      const vec3 reflected = rest[s].reflected + vec3(a.x + a.w + b.z + c.y, a.y + b.x + b.w + c.z,
                                                      a.z + b.y + c.x + c.w);
      const vec3 sum = glm::max(glm::max(reflected, vec3(0.0F)) + direct, vec3(0.0F));
      for (std::size_t k = 0; k < 3; ++k) lux[k][s] = sum[static_cast<int>(k)];
    }
  });
  return lux;
}

}  // namespace soffit::relight

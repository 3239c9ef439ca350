// SPDX-License-Identifier: MIT
#include "core/render/pixel_pattern.h"

#include "core/math/sampling.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace soffit::render {
namespace {

/// Second component of the (0,2)-sequence: direction numbers v_{k+1} = v_k xor v_k / 2.
double sobolSecond(std::uint32_t i) {
  std::uint32_t bits = 0;
  for (std::uint32_t v = 1U << 31U; i != 0; i >>= 1U, v ^= v >> 1U) {
    if ((i & 1U) != 0) bits ^= v;
  }
  return static_cast<double>(bits) * 0x1p-32;
}

double tent(double u) {
  return u < 0.5 ? std::sqrt(2.0 * u) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * u);
}

}  // namespace

std::vector<vec2> pixelPattern(int samples) {
  std::vector<vec2> pattern;
  // Half a stratum, so that the points lie in the middle of theirs; one sample is the centre.
  const double shift = 0.5 / static_cast<double>(std::bit_ceil(static_cast<unsigned>(samples)));
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(samples); ++i) {
    pattern.emplace_back(tent(radicalInverse2(i) + shift), tent(sobolSecond(i) + shift));
  }
  return pattern;
}

float textureShare(std::size_t samples) {
  return 1.0F / std::sqrt(static_cast<float>(std::max<std::size_t>(samples, 1)));
}

}  // namespace soffit::render

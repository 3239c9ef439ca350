// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

/// Maps from the unit square to the shapes that are integrated over, and frames.
namespace soffit {

/// Two unit tangents t, b with (t, b, n) right-handed and orthonormal; n unit.
/// Source: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
template <class V>
void orthonormalBasis(const V& n, V& t, V& b) {
  using S = typename V::value_type;
  const S sign = std::copysign(S(1), n.z);
  const S a = S(-1) / (sign + n.z);
  const S c = n.x * n.y * a;
  t = V(S(1) + sign * n.x * n.x * a, sign * c, -sign * n.x);
  b = V(c, sign + n.y * n.y * a, -n.y);
}

/// Area-preserving map of the unit square to the unit disk (Shirley & Chiu 1997).
inline vec2 concentricDisk(float u, float v) {
  const float a = 2.0F * u - 1.0F;
  const float b = 2.0F * v - 1.0F;
  if (a == 0.0F && b == 0.0F) return {0.0F, 0.0F};
  constexpr float kQuarter = 0.785398163397448F;
  float r = 0.0F;
  float phi = 0.0F;
  if (std::abs(a) > std::abs(b)) {
    r = a;
    phi = kQuarter * (b / a);
  } else {
    r = b;
    phi = 2.0F * kQuarter - kQuarter * (a / b);
  }
  return {r * std::cos(phi), r * std::sin(phi)};
}

/// Cosine-distributed direction about +z; density cos(theta) / pi.
inline vec3 cosineHemisphere(float u, float v) {
  const vec2 d = concentricDisk(u, v);
  return {d.x, d.y, std::sqrt(std::max(0.0F, 1.0F - d.x * d.x - d.y * d.y))};
}

/// Uniform direction on the sphere; density 1 / (4 pi).
inline vec3 uniformSphere(float u, float v) {
  const float z = 1.0F - 2.0F * u;
  const float r = std::sqrt(std::max(0.0F, 1.0F - z * z));
  const float phi = 6.283185307179586F * v;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Van der Corput radical inverse in base 2, in [0, 1).
inline double radicalInverse2(std::uint32_t i) {
  i = (i << 16U) | (i >> 16U);
  i = ((i & 0x00ff00ffU) << 8U) | ((i & 0xff00ff00U) >> 8U);
  i = ((i & 0x0f0f0f0fU) << 4U) | ((i & 0xf0f0f0f0U) >> 4U);
  i = ((i & 0x33333333U) << 2U) | ((i & 0xccccccccU) >> 2U);
  i = ((i & 0x55555555U) << 1U) | ((i & 0xaaaaaaaaU) >> 1U);
  return static_cast<double>(i) * 0x1p-32;
}

/// The i-th point of the R2 sequence (Roberts 2018), low-discrepancy in the unit square.
inline dvec2 r2Sequence(std::uint32_t i) {
  const double x = 0.5 + 0.7548776662466927 * static_cast<double>(i);
  const double y = 0.5 + 0.5698402909980532 * static_cast<double>(i);
  return {x - std::floor(x), y - std::floor(y)};
}

}  // namespace soffit

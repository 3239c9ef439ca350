// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/rng.h"
#include "core/math/vec.h"

#include <cmath>

namespace soffit::glossy {

inline dvec3 randomDirection(Rng& rng) {
  const double z = 2.0 * rng.uniformDouble() - 1.0;
  const double phi = 2.0 * kPi * rng.uniformDouble();
  const double s = std::sqrt((1.0 - z) * (1.0 + z));
  return {s * std::cos(phi), s * std::sin(phi), z};
}

inline dvec3 upperDirection(Rng& rng) {
  dvec3 d = randomDirection(rng);
  d.z = std::abs(d.z);
  return d;
}

}  // namespace soffit::glossy

// SPDX-License-Identifier: MIT
#include "core/light/white.h"

#include "core/color/cct.h"
#include "core/color/white_balance.h"
#include "core/light/emitter.h"

#include <algorithm>

namespace soffit::light {

double whiteOf(std::span<const Luminaire> luminaires) {
  dvec3 sum(0.0);
  for (const Luminaire& l : luminaires) {
    if (!l.on) continue;
    const double stored = l.distribution.table ? l.distribution.table->flux() : 0.0;
    sum += std::max(0.0, l.dimming * l.flux.value_or(stored)) * emissionColor(l.colour);
  }
  const double luminance = glm::dot(sum, kLuminance);
  if (!(luminance > 0.0)) return 0.0;
  sum /= luminance;
  constexpr double kSame = 1e-3;  // nobody tells it from daylight
  const dvec3 off = glm::abs(sum - dvec3(1.0));
  if (std::max({off.x, off.y, off.z}) < kSame) return 0.0;
  return color::correlatedTemperature(color::xyzFromRec709(sum));
}

}  // namespace soffit::light

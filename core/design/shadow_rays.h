// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/light/emitter.h"
#include "core/light/receivers.h"

#include <cstdint>
#include <span>

namespace soffit::design {

/// Direct light the usual way, as a yardstick for the bitmask: N shadow rays per point.
///
///   E = E_unoccluded * sum f V / sum f,   f = cos I(direction) / r^2        (numerics.md 1.12)
///
/// over N low-discrepancy points on the emitter, turned anew for every receiver, V by one ray
/// each. Same unoccluded term as light::directIlluminance. Luminaires' bodies do not block here.
///
/// rays  per receiver, 1..4096.   lux, lit  as in light::directIlluminance().
/// Returns the number of rays traced. Does not depend on the number of threads.
std::uint64_t shadowRayIlluminance(const light::Emitter& emitter, const light::Receivers& receivers,
                                   const geometry::RayCaster& caster, int rays,
                                   std::span<float> lux, std::span<std::uint8_t> lit);

}  // namespace soffit::design

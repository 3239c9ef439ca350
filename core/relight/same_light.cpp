// SPDX-License-Identifier: MIT
#include "core/relight/same_light.h"

namespace soffit::relight {

bool sameLight(const light::Emitter& a, const light::Emitter& b) {
  return a.kind == b.kind && a.position == b.position && a.world_from_light == b.world_from_light &&
         a.outline == b.outline && a.disk == b.disk && a.radius == b.radius && a.axis == b.axis &&
         a.half_length == b.half_length && a.corners == b.corners && a.flux == b.flux &&
         a.lambertian == b.lambertian && a.table == b.table && a.table_scale == b.table_scale &&
         a.casts_shadow == b.casts_shadow;
}

}  // namespace soffit::relight

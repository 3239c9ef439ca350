// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/emitter.h"
#include "core/math/vec.h"

namespace soffit::render {

/// A direction towards a luminaire, chosen at random from a point.
struct LightAim {
  dvec3 direction{0.0};   ///< unit
  double distance = 0.0;  ///< m; 0: there is none
  dvec3 normal{0.0};      ///< of the luminaire's surface there
  double pdf = 0.0;       ///< sr^-1; 0 for a point source
  vec3 intensity{0.0F};   ///< point sources: normal illuminance at the origin, lux, RGB; else 0
};

/// Aims at a luminaire; u in [0,1)^2. Spheres: uniform in the cone that they fill (none from
/// inside); tubes: uniform on the half that is turned towards `origin`; others: uniform by area.
LightAim aimAt(const light::Emitter& emitter, const dvec3& origin, const vec2& u);

/// The density, sr^-1, with which aimAt() finds a place of the luminaire that is seen from
/// `origin` along `direction` (unit) at `distance`, where its surface has `normal`.
double aimPdf(const light::Emitter& emitter, const dvec3& origin, const dvec3& direction,
              double distance, const dvec3& normal);

}  // namespace soffit::render

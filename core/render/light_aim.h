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

/// Aims at a point chosen uniformly on the surface, for spheres and tubes on the half that is
/// turned towards `origin`; u in [0,1)^2.
LightAim aimAt(const light::Emitter& emitter, const dvec3& origin, const vec2& u);

/// Density per m^2 of the points that aimAt() chooses among; the emitter has an area.
double areaDensity(const light::Emitter& emitter);

}  // namespace soffit::render

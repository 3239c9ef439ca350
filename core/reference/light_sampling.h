// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/reference/light_shape.h"

/// Points on emitters, drawn for a receiver at y so that near and large emitters are sampled about
/// evenly over the directions in which y sees them. The engine's own sampling is not used here.
namespace soffit::reference {

/// density is per square metre of emitting surface; 1 for a point source (a discrete choice);
/// 0: nothing can be seen from y.
struct LightPoint {
  dvec3 point{0.0};
  dvec3 normal{0.0};
  double density = 0.0;
};

/// Methods: Lambertian spheres by the cone that they fill, near Lambertian rectangles by solid
/// angle (Ureña, Fajardo & King 2013, "An Area-Preserving Parametrization for Spherical
/// Rectangles"), Lambertian tubes by the visible strip and equal angles along it, everything else
/// uniformly by area. u in [0, 1)^2.
LightPoint sampleLight(const LightShape& light, const dvec3& y, const dvec2& u);

/// The density that sampleLight() has from y at a point on the emitter with this normal.
double lightDensity(const LightShape& light, const dvec3& y, const dvec3& point,
                    const dvec3& normal);

}  // namespace soffit::reference

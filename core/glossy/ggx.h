// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

/// The specular lobe of interfaces.md, Materials, in double precision, as tables are made from it:
/// GGX with Smith's height-correlated shadowing, single scattering; Schlick's Fresnel term apart.
///
/// Directions are unit, point away from the surface, in the frame of the normal (+z); alpha in
/// (0, 1]. Sources: Walter et al. 2007 (D), Heitz 2014 (eq. 99), Heitz 2018 (visible normals),
/// Schlick 1994.
namespace soffit::glossy {

/// (1 - cosine)^5: Schlick's F = f0 + (1 - f0) of this.
double schlickRise(double cosine);

/// D(h), sr^-1: D cos integrates to 1 over the half vectors.
double ggxDensity(double cos_h, double alpha);

/// Smith's Lambda, (sqrt(1 + alpha^2 tan^2) - 1) / 2; very large at the horizon.
double smithLambda(double cosine, double alpha);

/// BRDF times cos(theta_i) with F = 1, sr^-1; 0 where either direction is below the surface.
double ggxLobe(const dvec3& wo, const dvec3& wi, double alpha);

/// An incident direction drawn by the visible normals and what it carries with F = 1.
struct GgxDraw {
  dvec3 wi{0.0, 0.0, 1.0};
  double weight = 0.0;  ///< lobe / density, in [0, 1]; 0 below the surface
  double cos_h = 1.0;   ///< between either direction and the half vector, for Schlick
};

/// u in [0, 1)^2; wo.z > 0. A function averaged over a set of points of the square, times weight,
/// is its integral against the lobe.
GgxDraw drawGgx(const dvec3& wo, double alpha, const dvec2& u);

}  // namespace soffit::glossy

// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

/// The specular lobe of interfaces.md, Materials: GGX with Smith's height-correlated shadowing and
/// Schlick's Fresnel term, single scattering.
///
/// Directions are unit, point away from the surface, in the frame of the shading normal (+z).
/// Sources: Walter et al. 2007 (D), Heitz 2014 (G2, eq. 99), Heitz 2018 (sampling visible
/// normals), Schlick 1994.
namespace soffit::render {

/// Below this alpha the lobe is a mirror.
inline constexpr float kMirrorAlpha = 1.0e-3F;

/// Schlick: f0 at normal incidence, 1 at grazing; cosine between direction and half vector.
float schlick(float f0, float cosine);

/// D(h), sr^-1, normalised so that the projected area of the normals is 1.
float ggxDensity(float cos_h, float alpha);

/// BRDF times cos(theta_i): f(wo, wi) |wi.z|, sr^-1. 0 for a mirror or below the surface.
float ggxReflection(const vec3& wo, const vec3& wi, float f0, float alpha);

/// Density per steradian with which sampleGgx() picks wi.
float ggxPdf(const vec3& wo, const vec3& wi, float alpha);

struct LobeSample {
  vec3 wi{0.0F, 0.0F, 1.0F};
  float weight = 0.0F;  ///< f(wo, wi) |wi.z| / pdf: reflectance carried by this ray, <= 1
  float pdf = 0.0F;     ///< sr^-1; 0 for a mirror (a discrete direction)
};

/// Draws an incident direction by the visible normals; u in [0,1)^2. A ray that would go below
/// the surface has weight 0.
LobeSample sampleGgx(const vec3& wo, float f0, float alpha, const vec2& u);

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

/// How a surface point reflects: a Lambertian part with exactly its albedo, and, where specular is
/// above 0, a GGX lobe (Walter et al. 2007; height-correlated Smith masking, Heitz 2014; Schlick's
/// Fresnel term toward 1 at grazing; single scattering). Roughness 0 is a mirror.
namespace soffit::reference {

struct Bsdf {
  dvec3 normal{0.0, 0.0, 1.0};  ///< unit, on the side that is looked at
  dvec3 diffuse{0.0};           ///< albedo per channel
  double specular = 0.0;        ///< reflectance at normal incidence, 0: no lobe
  double alpha = 0.25;          ///< roughness squared; 0: mirror
};

/// A direction drawn from a Bsdf. weight = f cos / density; for a mirror reflection the finite
/// limit of it, with density 0 to say so.
struct BsdfSample {
  dvec3 direction{0.0};
  dvec3 weight{0.0};
  double density = 0.0;  ///< per steradian
};

/// The reflected light is f = diffuse / pi + lobe, without mirrors; wo and wi unit, pointing away
/// from the surface; 0 unless both are above it.
dvec3 evaluate(const Bsdf& bsdf, const dvec3& wo, const dvec3& wi);

/// Density per steradian of sample() at wi, without mirrors.
double density(const Bsdf& bsdf, const dvec3& wo, const dvec3& wi);

/// Draws wi for wo: u.z chooses the lobe, u.x and u.y the direction. A weight of 0 means that the
/// direction fell below the surface.
BsdfSample sample(const Bsdf& bsdf, const dvec3& wo, const dvec3& u);

/// A rough albedo toward wo, per channel, for decisions about going on.
dvec3 albedo(const Bsdf& bsdf, const dvec3& wo);

}  // namespace soffit::reference

// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/material.h"
#include "core/transfer/texels.h"

#include <array>
#include <span>
#include <vector>

namespace soffit::relight {

/// Reflectance per slot as the interactive bounce uses it, linear Rec.709 per channel.
struct Reflectances {
  std::array<std::vector<float>, 3> rho;
  bool grey = true;  ///< all channels are equal everywhere
};

/// Diffuse albedo x the texture around each texel, plus the specular lobe's hemispherical albedo
/// (interfaces.md, Materials: until glossy transfer carries the lobe). Glass: 0. At most 1.
Reflectances makeReflectances(const transfer::Texels& texels, std::span<const scene::Material> materials);

/// Share of uniform hemispherical light that the GGX lobe of a material reflects, 0..1: 2 int
/// albedo(mu) mu dmu with VNDF sampling (Heitz 2018), Smith height-correlated masking, Schlick's
/// Fresnel from `specular`; single scattering. Quadrature error below 2e-3.
double lobeAlbedo(double specular, double roughness);

}  // namespace soffit::relight

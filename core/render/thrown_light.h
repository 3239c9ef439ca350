// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/relight/lighting.h"
#include "core/render/view_scene.h"

#include <cstddef>
#include <cstdint>

/// Light that surfaces with a specular lobe throw on others: what a polished floor casts on the
/// ceiling. The engine's operators reflect diffusely and take a lobe as so much more of it
/// (core/relight/reflectance.h); this is where the lobe really sends its light.
namespace soffit::render {

struct ThrownLightOptions {
  std::size_t samples = std::size_t{1} << 18U;  ///< places on reflecting surfaces per pass
  /// Passes follow until the RMS noise over all texels is this share of their mean light.
  double noise = 0.004;
  int most_passes = 64;
  int most_reflections = 3;  ///< by lobes one after the other, at least 1
  std::uint64_t seed = 1;
};

/// RGB lux per slot of the engine's texels of light whose last reflection was specular.
///
/// Particles start on the reflecting surfaces themselves, at places drawn by the light that arrives
/// there times what the lobe reflects: one that mirrors a luminaire, the sun or a picture's bright
/// spot (chosen by what the texel has of it, LampChoice; a shadow ray), one that mirrors the lit
/// room (a direction by the cosine; what it meets shows diffuse albedo times lighting.total()). The
/// lobe is drawn by its visible normals (Heitz 2018) with the light's direction for the eye's,
/// which is the same by reciprocity; where the ray ends its light is counted, and goes on where
/// that surface reflects too. Unbiased for the diffuse light that it is given, up to the texel's
/// size; normal maps and vertex normals as pictures have them. Luminaires let light through unless
/// they cast shadows; glass dims what passes and mirrors nothing here.
///
/// The same for any number
/// of threads. scene: the one that `lighting` is for, with the same luminaires. Without specular
/// surfaces: empty planes, at no cost. Errors: cancelled.
Result<relight::Planes> thrownLight(const ViewScene& scene, const relight::Lighting& lighting,
                                    const ThrownLightOptions& options = {}, const Job& job = {});

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#pragma once

#include "core/render/surface_sample.h"
#include "core/render/view_scene.h"

namespace soffit::render {

struct HighlightOptions {
  int shadow_rays =
      16;  ///< per luminaire whose highlight is seen, to points spread over it by area
  float least_radiance = 1.0e-3F;  ///< cd/m2: darker highlights are left out
};

/// What the specular lobe of a material (f0, alpha) reflects of luminaires toward the eye, cd/m2:
/// luminance toward the point times Fresnel's term (both as the luminaire's middle has them) times
/// the lobe's weight without it times the share of the lobe that the luminaire fills (linearly
/// transformed cosines, core/glossy/ltc_light.h) times the share of the luminaire that is not
/// hidden. Points by their intensity and the lobe itself. Mirrors (alpha < kMirrorAlpha) have no
/// highlights: they show luminaires.
vec3 lampHighlights(const ViewScene& scene, const SurfaceSample& at, float f0, float alpha,
                    const HighlightOptions& options = {});

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/render/illumination.h"
#include "core/render/view_scene.h"

namespace soffit::render {

/// A place on a surface that a ray met, as it is shaded.
struct SurfaceSample {
  SurfacePoint point;
  vec3 albedo{0.0F};       ///< diffuse, texture applied
  float alpha = 0.25F;     ///< GGX, roughness map applied
  vec3 to_eye{0.0F};       ///< unit
  float footprint = 0.0F;  ///< width of what the ray stands for, m, across the ray
  std::uint32_t surface = 0;
  std::uint32_t material = 0;
};

/// How surfaces are prepared for shading.
struct SurfaceOptions {
  float spread = 0.0F;     ///< rad: the footprint grows by this times the distance
  float footprint = 0.0F;  ///< m, at the ray's origin
  float texture_share =
      1.0F;  ///< of the footprint that textures are averaged over: rays beside it do the rest
  bool plain_normals =
      false;  ///< shading normal = geometric normal (illuminance of the real plane)
};

/// Shades out a hit of the scene's caster. ray.direction unit.
///
/// The normals face the eye. Vertex normals and normal maps (tangent space, x along u, y along v,
/// 0.5 0.5 1 is flat) make the shading normal, bent where it would face away from the eye. Where
/// vertex normals make a surface look convex, the position is lifted to the curve that they
/// describe, so that the facets do not shade themselves (Hanika 2021, "Hacking the Shadow
/// Terminator", Ray Tracing Gems II). It is drawn toward the eye along the surface by 1 mm, or half
/// the footprint if that is less, so that the foot of a wall is not on the wall as well; and never
/// further than half the way to its triangle's edge, beyond which the surface may bend. A roughness
/// map makes no mirrors of what is none elsewhere.
SurfaceSample sampleSurface(const ViewScene& scene, const geometry::Ray& ray,
                            const geometry::Hit& hit, const SurfaceOptions& options);

}  // namespace soffit::render

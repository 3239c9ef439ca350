// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/geometry/ray_caster.h"
#include "core/reference/bsdf.h"
#include "core/scene/material.h"

#include <cstdint>
#include <span>

namespace soffit::reference {

/// A point of the static geometry, as a ray has met it.
struct SurfacePoint {
  dvec3 position{0.0};  ///< relative to the mesh's origin
  Bsdf bsdf;            ///< its normal is geometric and on the ray's side
};

/// The point that a ray has hit and how it reflects there. Reflectances come from the triangle's
/// material, its diffuse and its roughness map; glass reflects nothing.
///
/// direction: of the ray, unit or not. hit.valid(). A triangle without a material in `materials`
/// has the default material.
SurfacePoint surfaceAt(const geometry::Mesh& mesh, std::span<const scene::Material> materials,
                       const geometry::Hit& hit, const dvec3& direction);

/// The bilinear value of a picture that repeats; u to the right, v upwards from the lower edge.
/// Pictures of 1 or 2 channels give their first for all three.
dvec3 lookUp(const scene::Image& image, const dvec2& uv);

}  // namespace soffit::reference

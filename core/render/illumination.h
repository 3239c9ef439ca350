// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <span>

namespace soffit::render {

/// A point of the static geometry that a picture needs light at. Scene-local frame
/// (world minus Mesh::origin).
struct SurfacePoint {
  vec3 position{0.0F};
  vec3 normal{0.0F, 0.0F, 1.0F};          ///< geometric, unit, on the side that is looked at
  vec3 shading_normal{0.0F, 0.0F, 1.0F};  ///< unit; differs with smooth or bumped surfaces
  std::uint32_t triangle = 0;             ///< index in the mesh
  vec2 barycentric{0.0F};                 ///< point = (1-u-v) a + u b + v c
  float blur = 0.0F;  ///< m; light may be averaged over so much about the point; 0: exact
};

/// Where pictures get their light from. Thread-safe.
class Illumination {
 public:
  virtual ~Illumination() = default;

  /// RGB illuminance in lux at surface points: `direct` from luminaires with exact visibility
  /// where a point asks for no blur, `indirect` after at least one reflection. All spans have the
  /// same length. Points that are neighbours in space should be neighbours in the span (a tile of a
  /// picture): the cost per point falls with coherence.
  virtual void evaluate(std::span<const SurfacePoint> points, std::span<vec3> direct,
                        std::span<vec3> indirect) const = 0;
};

}  // namespace soffit::render

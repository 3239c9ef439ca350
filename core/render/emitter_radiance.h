// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/emitter.h"
#include "core/math/vec.h"

#include <vector>

namespace soffit::render {

/// What luminaires look like: their luminance toward an eye.
///
/// Lambertian shapes: flux / (pi area). Measured photometry: I(direction) over the projected area
/// of the shape, which is limited from below by 1/20 of the greatest (interfaces.md, Photometry on
/// shapes): |cos| area for flat shapes, pi r^2 for spheres, 2 r length sin for tubes, the sum of
/// the front faces for meshes (tabulated).
class EmitterRadiance {
 public:
  explicit EmitterRadiance(const light::Emitter& emitter);

  /// Linear Rec.709, cd/m^2, dimming and colour applied. `normal` of the surface seen, unit;
  /// `to_eye` unit, from the luminaire. 0 on a side that does not emit.
  [[nodiscard]] vec3 toward(const light::Emitter& emitter, const vec3& normal,
                            const vec3& to_eye) const;

 private:
  [[nodiscard]] double projectedArea(const light::Emitter& emitter, const dvec3& direction) const;
  std::vector<double> mesh_areas_;  // rows of latitude, columns of longitude
  double smallest_ = 0.0;
};

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/emitter.h"

namespace soffit::light {

/// A point on an emitter chosen at random.
struct EmitterSample {
  dvec3 point{0.0};
  dvec3 normal{0.0};   ///< of the surface, unit; zero for a point source
  double pdf_area = 0; ///< density per m^2; 1 for a point source (a discrete choice)
};

/// Uniform by area from u in [0,1)^2 (triangles of a mesh are chosen by u.x and its remainder is
/// reused). For a point the point itself.
EmitterSample sampleByArea(const Emitter& emitter, const dvec2& u);

}  // namespace soffit::light

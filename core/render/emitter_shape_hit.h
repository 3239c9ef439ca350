// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/emitter.h"
#include "core/math/vec.h"

#include <limits>
#include <optional>

namespace soffit::render {

/// Where a ray meets the surface of a luminaire.
struct ShapeHit {
  double t = std::numeric_limits<double>::infinity();
  dvec3 normal{0.0};   ///< unit, outward (planar: the emitting side)
  bool emits = false;  ///< this side gives light; else it is the black body of casts_shadow
};

/// A ray in double precision; direction unit, t in (t_min, t_max).
struct PreciseRay {
  dvec3 origin{0.0};
  dvec3 direction{0.0};
  double t_min = 0.0;
  double t_max = std::numeric_limits<double>::infinity();
};

/// The nearest side of a planar, sphere or tube emitter that shows: emitting sides always, others
/// only with casts_shadow (then black; a tube's ends are closed). Points and meshes: nothing.
std::optional<ShapeHit> hitShape(const light::Emitter& emitter, const PreciseRay& ray);

}  // namespace soffit::render

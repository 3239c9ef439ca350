// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/emitter.h"
#include "core/math/vec.h"

#include <optional>
#include <span>
#include <vector>

/// Where lines of sight meet the emitting side of a luminaire.
namespace soffit::light {

/// A point of an emitting surface seen from a probe.
struct EmitterHit {
  double t = 0.0;     ///< distance along the unit direction
  dvec3 normal{0.0};  ///< of the emitting side, unit; for two-sided light turned to the probe
};

/// A part of an emitter that is drawn by itself: the whole of a plane shape or a sphere, a section
/// of a tube, one triangle of a mesh.
struct EmitterPart {
  dvec3 center{0.0};    ///< of a ball around the part, relative to the scene origin
  double radius = 0.0;  ///< of that ball
  std::size_t triangle = 0;
  double begin = 0.0, end = 0.0;  ///< of a section, along the tube's axis from its middle
};

/// The parts of an emitter; none for a point.
std::vector<EmitterPart> partsOf(const Emitter& emitter);

/// Solid angle that the emitting side of a part has at `probe`, hidden or not, in steradians: exact
/// for outlines, triangles and spheres, 1e-4 for disks (a polygon of 128 corners and the same
/// area); nothing for tubes.
std::optional<double> solidAngleOf(const Emitter& emitter, const EmitterPart& part,
                                   const dvec3& probe);

/// The nearest point of a part that emits towards `probe`, along the unit `direction` from it.
/// Sides that do not emit, and what is seen at less than 1e-4 of the straight view, are missed.
std::optional<EmitterHit> hitPart(const Emitter& emitter, const EmitterPart& part,
                                  const dvec3& probe, const dvec3& direction);

}  // namespace soffit::light

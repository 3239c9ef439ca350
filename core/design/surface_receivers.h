// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/lighting.h"
#include "core/relight/solver.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace soffit::design {

/// A point on a surface of the static geometry. Scene-local frame (world minus Mesh::origin).
struct SurfaceReceiver {
  dvec3 position{0.0};
  dvec3 normal{0.0, 0.0, 1.0};  ///< geometric, unit, on the side that is lit
  std::uint32_t triangle = 0;   ///< of the mesh
  bool front = true;            ///< the side where the triangle winds counter-clockwise
};

/// Receivers drawn uniformly by area from the sides that carry light, the texels that the engine
/// holds for hidden (inside furniture) left out. The same seed gives the same points.
///
/// Returns fewer than `count`, possibly none, when hardly any surface carries light.
std::vector<SurfaceReceiver> drawReceivers(const relight::Solver& solver, std::size_t count,
                                           std::uint64_t seed);

/// The part of `receivers` that gets light, most `count` of them in their order. What is lit is for
/// the reference to say: the back of a board that hangs on a wall, and the wall behind it, belong to
/// no lit surface, whatever the texel beside them shows.
std::vector<SurfaceReceiver> litReceivers(
    std::span<const SurfaceReceiver> receivers, std::size_t count,
    const std::function<std::vector<bool>(std::span<const SurfaceReceiver>)>& lit_in_reference);

/// The receiver as a sensor in the world.
scene::Sensor toSensor(const SurfaceReceiver& receiver, const dvec3& origin);

}  // namespace soffit::design

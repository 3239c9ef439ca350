// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/scene/scene.h"

#include <span>
#include <vector>

namespace soffit::reference {

/// A sensor within this distance of a surface lies on it.
inline constexpr double kOnSurface = 1e-4;  // m

/// Where rays of sensors start, relative to the mesh's origin: at the sensor, or, within
/// kOnSurface of a surface, just off that surface on the side that the sensor's normal points to
/// (the side that the sensor is on, if its normal runs along the surface).
std::vector<dvec3> placeSensors(const geometry::Mesh& mesh, std::span<const scene::Sensor> sensors);

}  // namespace soffit::reference

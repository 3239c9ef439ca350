// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <vector>

/// What a scene must satisfy before anything is computed from it, wherever it came from: a
/// project file, the command line or the editor.
namespace soffit::scene {

/// Every fault of a scene, in the order of the project file; none: the scene is sound.
///
/// Error::place is the path inside the project ("luminaires.Panel 1.flux",
/// "layouts.Evening.luminaires.Panel 1.dimming", "work_planes.Desks.u"). Checked are: names
/// (present and unique per kind), finite numbers and their ranges, luminaire shapes and emission
/// (light::makeEmitter) in the base and under every layout, reflectances (0..1, specular +
/// diffuse at most 1), glass, cameras that look somewhere, work planes with an area and cells,
/// triangle indices of the mesh, and the quality preset's name.
std::vector<Error> findFaults(const Scene& scene);

/// Coordinates beyond this, m, are slips of the pen; single precision would not tell rooms apart.
inline constexpr double kFarthest = 1e7;

/// Finite and within kFarthest of the world's origin along each axis.
bool isPlace(const dvec3& p);

/// One material; place is the field ("diffuse", "glass.index").
Result<void> checkMaterial(const Material& material);

/// One camera; place is the field.
Result<void> checkCamera(const Camera& camera);

/// One work plane; place is the field. At most 10 million points.
Result<void> checkWorkPlane(const WorkPlane& plane);

/// The highest transmittance at normal incidence that a lossless slab of this refractive index
/// has with all internal reflections: (1 - R) / (1 + R), R = ((n - 1) / (n + 1))^2.
double losslessTransmittance(double index);

}  // namespace soffit::scene

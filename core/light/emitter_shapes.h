// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/light/emitter.h"
#include "core/light/luminaire.h"

namespace soffit::light {

/// Sets the geometry of an emitter (kind, outline, corners, radius, area, bounds, ...) from a
/// shape. emitter.position and emitter.world_from_light are read and must be set before.
///
/// scale > 0, lengths of the shape are multiplied by it. A mesh's triangles without area are
/// left out. Errors (place is the shape's name in the project file): sizes that are not positive
/// and finite, a bad polygon, a mesh without triangles.
Result<void> placeShape(const Shape& shape, double scale, Emitter& emitter);

}  // namespace soffit::light

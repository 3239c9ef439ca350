// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/scene.h"

#include <cstddef>

namespace soffit::design {

/// A room of 16 x 12 x 3 m with 48 plinths that carry a sphere each, tessellated so that the whole
/// has about `triangles` (at least 1,000, which the coarsest spheres take; off by less than a
/// fifth), and square panels in a grid under the ceiling, 60,000 lm together. Materials: walls 0.7,
/// plinths 0.5, spheres 0.3.
scene::Scene growthRoom(std::size_t triangles, std::size_t luminaires);

}  // namespace soffit::design

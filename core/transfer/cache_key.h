// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/operators.h"
#include "core/transfer/static_scene.h"

#include <cstdint>
#include <string>

namespace soffit::transfer {

/// Raise this with every change of what bake() computes or of how it is stored: bakes of other
/// versions are not found any more.
inline constexpr std::uint32_t kBakeVersion = 1;

/// Names a bake by everything that decides it, as 32 hexadecimal digits (128 bits): triangles,
/// their positions, materials (numbers, not names or reflectances), texture coordinates and lit
/// sides, all settings and kBakeVersion.
///
/// Luminaires, layouts, reflectances and environment do not count. The one exception comes with
/// StaticScene::sides: a light that enters or leaves a closed solid changes which sides are lit.
/// Neither does Mesh::origin: bakes are scene-local. About 10 GB/s.
std::string cacheKey(const StaticScene& scene, const BakeSettings& settings);

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/operators.h"
#include "core/transfer/static_scene.h"

#include <cstdint>
#include <string>

namespace soffit::transfer {

/// The form in which bakes are stored: raise it when that changes. What bake() computes need not
/// be counted here: the hash of its sources is part of the key.
inline constexpr std::uint32_t kBakeVersion = 14;

/// Names a bake by everything that decides it, as 32 hexadecimal digits (128 bits): triangles,
/// their positions, materials (numbers, not names or reflectances), which are glass with what index
/// and transmittance (rays of the bake pass through and are mirrored), texture coordinates and lit
/// sides, all settings, kBakeVersion and the sources of the bake itself.
///
/// Luminaires, layouts, reflectances, environment and Mesh::origin do not count. The one exception
/// comes with StaticScene::sides: a light that enters or leaves a closed solid changes which sides
/// are lit. About 10 GB/s.
std::string cacheKey(const StaticScene& scene, const BakeSettings& settings);

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#pragma once

#include "core/prt/surfaces.h"
#include "core/prt/texture_layout.h"

#include <array>
#include <cstdint>
#include <span>

namespace soffit::prt {

using SetKey = std::array<std::uint64_t, 2>;

/// Names a texture set by all that decides its texels and what it blocks, 128 bits: its triangles'
/// corners, shading normals, texture coordinates, sides, glass and normal maps, and the options.
/// Reflectances do not count: they enter with the bounces. What other objects do to it is found by
/// rays (retraceShadows()). About 5 GB/s.
SetKey setKey(const Surfaces& surfaces, std::span<const std::uint32_t> triangles,
              const TextureOptions& options);

}  // namespace soffit::prt

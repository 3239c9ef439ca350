// SPDX-License-Identifier: MIT
#pragma once

#include "core/daylight/open_sky.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

/// What a building's texels see of the sky, kept beside its bake: a second call finds it. Like the
/// bake it depends on geometry and settings alone.
namespace soffit::relight {

/// The file that belongs to a bake's key, in transfer::cacheFolder().
std::filesystem::path skyPath(std::string_view key);

/// The stored look of receivers with these normals; null when there is none, or when it is damaged
/// or of other receivers: then they look again.
std::shared_ptr<const daylight::OpenSky> readSky(const std::filesystem::path& path,
                                                 std::span<const vec3> normals);

/// Stores a look, whole or not at all; a cache that cannot be written is no fault.
void writeSky(const std::filesystem::path& path, const daylight::OpenSky& sky);

}  // namespace soffit::relight

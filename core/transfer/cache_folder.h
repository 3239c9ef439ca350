// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace soffit::transfer {

/// What all bakes in the cache may take together; a bake of 50,000 texels takes some 35 MB.
inline constexpr std::uintmax_t kMostCacheBytes = std::uintmax_t{4} << 30U;

/// Where bakes are kept between calls: $SOFFIT_CACHE, else `soffit` in the user's cache folder
/// ($XDG_CACHE_HOME when it is absolute, ~/.cache; ~/Library/Caches on macOS, %LOCALAPPDATA% on
/// Windows), else in the folder for temporary files. It need not exist.
std::filesystem::path cacheFolder();

/// Marks a bake as used now: the least recently used ones go first.
void touchBake(const std::filesystem::path& path);

/// Removes the least recently used bakes (*.bake) until the rest take at most `most_bytes`, never
/// `keep`; and what writers that were killed left behind more than a day ago. What cannot be
/// removed stays: this is housekeeping, nobody is told.
void trimCache(const std::filesystem::path& folder, std::uintmax_t most_bytes,
               const std::filesystem::path& keep);

}  // namespace soffit::transfer

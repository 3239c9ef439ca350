// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/transfer/operators.h"
#include "core/transfer/static_scene.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Bakes that are kept on disk between calls, one file per scene and settings (cache_key.h), in
/// the user's cache folder (cache_folder.h).
namespace soffit::transfer {

/// The file of a bake in cacheFolder().
std::filesystem::path cachePath(std::string_view key);

/// What is stored at a path. Neither operators nor trouble: there is no such file.
struct CacheRead {
  std::shared_ptr<const Operators> operators;
  std::string trouble;  ///< one line for the user: the file, what is wrong, that it is baked again
};

/// Reads a stored bake and checks all of it: truncation, changed bytes, another version and
/// another key end in `trouble`, never in a crash or in wrong numbers.
CacheRead readCache(const std::filesystem::path& path, std::string_view key);

/// Stores a bake: a temporary file in the same folder (made when missing) that reaches the disk
/// and is then renamed, so that readers and other writers always meet a whole file.
///
/// Errors: the folder cannot be made or written, the disk is full; nothing is left behind then.
Result<void> writeCache(const std::filesystem::path& path, std::string_view key,
                        const Operators& operators);

/// The stored bake when there is one, else bake(), whose result is then stored (and the cache
/// kept below kMostCacheBytes).
///
/// use_cache  false: nothing is read or written.
/// coarse     called only when something is baked; may be empty.
/// counts     null, or gets the bake's; of a stored bake the seconds that reading took.
/// cached     becomes whether the bake was stored already.
/// messages   gets one line for what the user should know: a damaged file, a cache that cannot be
///            written. Neither stops the work.
/// Errors: those of bake().
Result<std::shared_ptr<const Operators>> bakeOrLoad(const StaticScene& scene,
                                                    const BakeSettings& settings, bool use_cache,
                                                    const Job& job, const CoarseResult& coarse,
                                                    BakeCounts* counts, bool& cached,
                                                    std::vector<std::string>& messages);

}  // namespace soffit::transfer

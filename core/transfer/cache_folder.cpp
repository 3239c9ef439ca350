// SPDX-License-Identifier: MIT
#include "core/transfer/cache_folder.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <system_error>
#include <tuple>
#include <vector>

namespace soffit::transfer {
namespace fs = std::filesystem;
namespace {

/// The value of an environment variable, empty when it is not set.
fs::path fromEnvironment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? fs::path() : fs::path(value);
}

fs::path userCacheFolder() {
#if defined(_WIN32)
  return fromEnvironment("LOCALAPPDATA");
#elif defined(__APPLE__)
  const fs::path home = fromEnvironment("HOME");
  return home.empty() ? home : home / "Library" / "Caches";
#else
  // The XDG base directory specification: a relative path is to be ignored.
  if (fs::path xdg = fromEnvironment("XDG_CACHE_HOME"); xdg.is_absolute()) return xdg;
  const fs::path home = fromEnvironment("HOME");
  return home.empty() ? home : home / ".cache";
#endif
}

struct StoredBake {
  fs::path path;
  fs::file_time_type used;
  std::uintmax_t bytes = 0;
};

}  // namespace

fs::path cacheFolder() {
  if (fs::path own = fromEnvironment("SOFFIT_CACHE"); !own.empty()) return own;
  if (const fs::path user = userCacheFolder(); !user.empty()) return user / "soffit";
  std::error_code failed;
  const fs::path temporary = fs::temp_directory_path(failed);
  return (failed ? fs::path(".") : temporary) / "soffit-cache";
}

void touchBake(const fs::path& path) {
  std::error_code ignored;
  fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
}

void trimCache(const fs::path& folder, std::uintmax_t most_bytes, const fs::path& keep) {
  const auto abandoned = fs::file_time_type::clock::now() - std::chrono::hours(24);
  std::vector<StoredBake> bakes;
  std::uintmax_t total = 0;
  std::error_code ignored;
  for (fs::directory_iterator it(folder, ignored), end; it != end; it.increment(ignored)) {
    std::error_code failed;
    if (!it->is_regular_file(failed) || failed) continue;
    const auto used = it->last_write_time(failed);
    const std::uintmax_t bytes = failed ? 0 : it->file_size(failed);
    if (failed) continue;  // another process was quicker
    const fs::path& path = it->path();
    if (path.extension() == ".tmp" && path.stem().stem().extension() == ".bake") {
      if (used < abandoned) fs::remove(path, failed);
    } else if (path.extension() == ".bake") {
      bakes.push_back({path, used, bytes});
      total += bytes;
    }
  }
  std::sort(bakes.begin(), bakes.end(), [](const StoredBake& a, const StoredBake& b) {
    return std::tie(a.used, a.path) < std::tie(b.used, b.path);
  });
  for (const StoredBake& bake : bakes) {
    if (total <= most_bytes) return;
    if (bake.path.filename() == keep.filename()) continue;
    std::error_code failed;
    if (fs::remove(bake.path, failed)) total -= bake.bytes;
  }
}

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#include "core/transfer/bake_cache.h"

#include "core/transfer/cache_file.h"
#include "core/transfer/cache_folder.h"
#include "core/transfer/cache_key.h"
#include "core/transfer/operators_check.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <random>
#include <system_error>
#include <utility>

namespace soffit::transfer {
namespace fs = std::filesystem;
namespace {

Error writeError(const fs::path& path, int code) {
  return {path.string(),
          fmt::format("the bake cannot be stored: {}", std::generic_category().message(code)),
          "Make room or choose another folder with SOFFIT_CACHE"};
}

std::string troubleLine(const fs::path& path, std::string_view what) {
  return fmt::format("{}: the stored bake is damaged ({}), so it is baked again.", path.string(),
                     what);
}

/// A new file beside `target`, removed again unless renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) {
    std::random_device random;
    do {
      path_ = target;
      path_ += fmt::format(".{:08x}{:08x}.tmp", random(), random());
      file_ = std::fopen(path_.c_str(), "wbx");  // x: never a file of another writer's
    } while (file_ == nullptr && errno == EEXIST);
    exists_ = file_ != nullptr;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    if (file_ != nullptr) std::fclose(file_);
    if (exists_) fs::remove(path_, ignored);
  }

  [[nodiscard]] bool valid() const { return file_ != nullptr; }
  bool write(std::span<const std::byte> bytes) {
    return std::fwrite(bytes.data(), 1, bytes.size(), file_) == bytes.size();
  }
  /// Has the content reach the disk before the name does. Returns errno, 0 when all went well.
  int renameTo(const fs::path& target) {
    if (std::fflush(file_) != 0 || ::fsync(::fileno(file_)) != 0) return errno;
    if (std::fclose(std::exchange(file_, nullptr)) != 0) return errno;
    std::error_code failed;
    fs::rename(path_, target, failed);
    exists_ = static_cast<bool>(failed);
    return failed.value();
  }

 private:
  fs::path path_;
  std::FILE* file_ = nullptr;
  bool exists_ = false;
};

/// The stored bake if it is there and belongs to this mesh.
CacheRead load(const fs::path& path, std::string_view key, const geometry::Mesh& mesh) {
  CacheRead read = readCache(path, key);
  if (read.operators == nullptr) return read;
  // Texels are looked up by mesh triangle, which the file alone cannot tell.
  if (read.operators->texels.charts.chart_of.size() != mesh.triangles.size() ||
      read.operators->coarse) {
    return {nullptr, troubleLine(path, "it belongs to another scene")};
  }
  touchBake(path);
  return read;
}

void store(const fs::path& path, std::string_view key, const Operators& operators, const Job& job,
           std::vector<std::string>& messages) {
  job.report("storing the bake", 0.0);
  if (const Result<void> written = writeCache(path, key, operators); !written) {
    messages.push_back(written.error().message());
    return;
  }
  trimCache(path.parent_path(), kMostCacheBytes, path);
  job.report("storing the bake", 1.0);
}

}  // namespace

fs::path cachePath(std::string_view key) {
  return cacheFolder() / fmt::format("{}.bake", key);
}

CacheRead readCache(const fs::path& path, std::string_view key) {
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  if (status.type() == fs::file_type::not_found) return {};
  if (!fs::is_regular_file(status))
    return {nullptr, troubleLine(path, "it is not a file that can be read")};
  std::ifstream in(path, std::ios::binary);
  const std::uintmax_t size = fs::file_size(path, failed);
  if (!in || failed) return {nullptr, troubleLine(path, "it is not a file that can be read")};
  ReadOperators read = readOperators(in, size, key);
  if (read.operators == nullptr) return {nullptr, troubleLine(path, read.trouble)};
  return {std::move(read.operators), {}};
}

Result<void> writeCache(const fs::path& path, std::string_view key, const Operators& operators) {
  if (const std::string part = inconsistency(operators); !part.empty()) {
    return Error{path.string(),
                 fmt::format("the bake cannot be stored: its {} do not fit together", part),
                 "This is a fault of Soffit's; please report it"};
  }
  std::error_code failed;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), failed);
  if (failed) return writeError(path, failed.value());
  errno = 0;
  TemporaryFile file(path);
  if (!file.valid()) return writeError(path, errno);
  const auto sink = [&](std::span<const std::byte> bytes) { return file.write(bytes); };
  if (!writeOperators(operators, key, sink)) return writeError(path, errno);
  if (const int code = file.renameTo(path); code != 0) return writeError(path, code);
  return {};
}

Result<std::shared_ptr<const Operators>> bakeOrLoad(const StaticScene& scene,
                                                    const BakeSettings& settings, bool use_cache,
                                                    const Job& job, const CoarseResult& coarse,
                                                    BakeCounts* counts, bool& cached,
                                                    std::vector<std::string>& messages) {
  cached = false;
  // Without geometry there is nothing to bake, and so nothing to keep.
  if (!use_cache || scene.mesh->triangles.empty())
    return bake(scene, settings, job, coarse, counts);
  const auto start = std::chrono::steady_clock::now();
  job.report("looking for a stored bake", 0.0);
  const std::string key = cacheKey(scene, settings);
  const fs::path path = cachePath(key);
  CacheRead read = load(path, key, *scene.mesh);
  job.report("looking for a stored bake", 1.0);
  if (!read.trouble.empty()) messages.push_back(std::move(read.trouble));
  if (read.operators != nullptr) {
    cached = true;
    if (counts != nullptr) {
      *counts = {};
      counts->seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      counts->first_result_seconds = counts->seconds;
    }
    return read.operators;
  }
  auto baked = bake(scene, settings, job, coarse, counts);
  if (baked) store(path, key, **baked, job, messages);
  return baked;
}

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#include "core/relight/sky_cache.h"

#include "core/transfer/bake_cache.h"
#include "core/transfer/cache_folder.h"
#include "core/transfer/content_hash.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace soffit::relight {
namespace fs = std::filesystem;
namespace {

/// Raised when the form or what a look finds changes.
constexpr std::uint64_t kVersion = 0x536f66665f736b01ULL;

struct Heading {
  std::uint64_t version = kVersion;
  std::uint64_t coarse = 0;
  std::uint64_t first_count = 0;
  std::uint64_t leaf_count = 0;
  std::uint64_t normals_hash = 0;
  std::uint64_t content_hash = 0;
};

std::uint64_t hashOf(std::span<const std::uint32_t> first, std::span<const std::uint32_t> leaves) {
  return transfer::hash64(std::as_bytes(first)) * 31U + transfer::hash64(std::as_bytes(leaves));
}

template <class T>
bool readInto(std::ifstream& in, std::span<T> items) {
  in.read(reinterpret_cast<char*>(items.data()), static_cast<std::streamsize>(items.size_bytes()));
  return static_cast<bool>(in);
}

template <class T>
void writeFrom(std::ofstream& out, std::span<const T> items) {
  out.write(reinterpret_cast<const char*>(items.data()),
            static_cast<std::streamsize>(items.size_bytes()));
}

}  // namespace

fs::path skyPath(std::string_view key) {
  return transfer::cachePath(fmt::format("{}-sky", key));
}

std::shared_ptr<const daylight::OpenSky> readSky(const fs::path& path,
                                                 std::span<const vec3> normals) {
  std::error_code failed;
  const std::uintmax_t size = fs::file_size(path, failed);
  if (failed) return nullptr;
  std::ifstream in(path, std::ios::binary);
  Heading heading;
  if (!readInto(in, std::span(&heading, 1))) return nullptr;
  // Sizes are checked against the file's before memory is taken for them.
  const std::uint64_t most = size / sizeof(std::uint32_t);
  if (heading.version != kVersion || heading.first_count > most || heading.leaf_count > most ||
      heading.normals_hash != transfer::hash64(std::as_bytes(normals)) ||
      sizeof(Heading) + (heading.first_count + heading.leaf_count) * sizeof(std::uint32_t) !=
          size) {
    return nullptr;
  }
  daylight::OpenSky::Look look;
  look.coarse = static_cast<int>(heading.coarse);
  look.first.resize(heading.first_count);
  look.leaves.resize(heading.leaf_count);
  if (!readInto(in, std::span(look.first)) || !readInto(in, std::span(look.leaves))) return nullptr;
  if (hashOf(look.first, look.leaves) != heading.content_hash) return nullptr;
  auto sky = daylight::OpenSky::restored(normals, std::move(look));
  if (!sky) return nullptr;
  transfer::touchBake(path);
  return std::make_shared<const daylight::OpenSky>(std::move(*sky));
}

void writeSky(const fs::path& path, const daylight::OpenSky& sky) {
  std::error_code failed;
  fs::create_directories(path.parent_path(), failed);
  if (failed) return;
  const daylight::OpenSky::Look& look = sky.found();
  const Heading heading{.coarse = static_cast<std::uint64_t>(look.coarse),
                        .first_count = look.first.size(),
                        .leaf_count = look.leaves.size(),
                        .normals_hash = transfer::hash64(std::as_bytes(sky.normals())),
                        .content_hash = hashOf(look.first, look.leaves)};
  std::random_device random;
  fs::path temporary = path;
  temporary += fmt::format(".{:08x}{:08x}.tmp", random(), random());
  {
    std::ofstream out(temporary, std::ios::binary);
    writeFrom(out, std::span(&heading, 1));
    writeFrom(out, std::span<const std::uint32_t>(look.first));
    writeFrom(out, std::span<const std::uint32_t>(look.leaves));
    out.flush();
    if (!out) {
      out.close();
      fs::remove(temporary, failed);
      return;
    }
  }
  fs::rename(temporary, path, failed);
  if (failed) {
    fs::remove(temporary, failed);
    return;
  }
  transfer::trimCache(path.parent_path(), transfer::kMostCacheBytes, path);
}

}  // namespace soffit::relight

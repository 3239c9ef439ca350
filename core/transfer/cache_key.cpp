// SPDX-License-Identifier: MIT
#include "core/transfer/cache_key.h"

#include "core/transfer/content_hash.h"

#include "bake_sources.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <iterator>
#include <span>
#include <type_traits>
#include <vector>

namespace soffit::transfer {
namespace {

/// Length and hash of each array, and single numbers: the key is the hash of these.
class Summary {
 public:
  template <class T>
  void add(const std::vector<T>& values) {
    const std::array<std::uint64_t, 2> hash = hash128(std::as_bytes(std::span(values)));
    for (const std::uint64_t word : {std::uint64_t{values.size()}, hash[0], hash[1]}) {
      words_.push_back(word);
    }
  }
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(T value) {
    if constexpr (std::is_floating_point_v<T>) {
      words_.push_back(std::bit_cast<std::uint64_t>(static_cast<double>(value)));
    } else {
      words_.push_back(static_cast<std::uint64_t>(value));
    }
  }
  [[nodiscard]] std::string hex() const {
    const std::array<std::uint64_t, 2> hash = hash128(std::as_bytes(std::span(words_)));
    return fmt::format("{:016x}{:016x}", hash[0], hash[1]);
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace

std::string cacheKey(const StaticScene& scene, const BakeSettings& settings) {
  // Bytes are hashed: there must be none that mean nothing.
  static_assert(sizeof(vec3) == 12 && sizeof(vec2) == 8 && sizeof(uvec3) == 12);
  Summary summary;
  summary.add(kBakeVersion);
  summary.add(std::vector<char>(std::begin(kBakeSources), std::end(kBakeSources)));
  summary.add(scene.mesh->positions);
  summary.add(scene.mesh->triangles);
  summary.add(scene.mesh->material_of);
  summary.add(scene.mesh->uvs);
  summary.add(scene.sides);
  // Rays of the bake pass and are mirrored by sheets: without glass nothing is added.
  if (scene.panes != nullptr) summary.add(scene.panes->content());
  // Taken apart like this, a setting that is added later does not compile until it counts too.
  const auto& [texels, whole_cells, least_cell, most_cell, patch, node_rays, trainings, field_rays, list_rays, max_rank,
               lists, tolerance, seed] = settings;
  summary.add(texels);
  summary.add(whole_cells);
  summary.add(least_cell);
  summary.add(most_cell);
  summary.add(patch);
  summary.add(node_rays);
  summary.add(trainings);
  summary.add(field_rays);
  summary.add(list_rays);
  summary.add(max_rank);
  summary.add(lists);
  summary.add(tolerance);
  summary.add(seed);
  return summary.hex();
}

}  // namespace soffit::transfer

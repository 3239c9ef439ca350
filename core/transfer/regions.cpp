// SPDX-License-Identifier: MIT
#include "core/transfer/regions.h"

#include <algorithm>
#include <numeric>

namespace soffit::transfer {
namespace {

constexpr std::uint32_t kLeastCells = 16;

/// Disjoint sets; the smaller index is the root, so the result does not depend on the order.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::vector<std::uint32_t> findRegions(const Texels& texels, std::span<const vec3> positions,
                                       std::span<const vec3> normals, const geometry::RayCaster* caster) {
  Sets sets(positions.size());
  std::vector<std::array<std::uint32_t, 2>> pairs;
  std::vector<geometry::Ray> rays;
  for (std::size_t c = 0; c < texels.charts.charts.size(); ++c) {
    const Chart& chart = texels.charts.charts[c];
    if (!chart.planar) continue;
    const Texels::Grid& grid = texels.grids[c];
    const auto per_side = static_cast<std::uint32_t>(grid.nu * grid.nv);
    const std::uint32_t sides = (chart.sides & kFront) != 0 && (chart.sides & kBack) != 0 ? 2U : 1U;
    const float lift = std::min(0.03F, 0.25F * std::min(grid.cell.x, grid.cell.y));
    for (std::uint32_t side = 0; side < sides; ++side) {
      const std::uint32_t* cells = &texels.cells[grid.first + side * per_side];
      for (int j = 0; j < grid.nv; ++j) {
        for (int i = 0; i < grid.nu; ++i) {
          const std::uint32_t a = cells[j * grid.nu + i];
          if (a == kNoTexel) continue;
          for (const auto& [di, dj] : {std::pair{1, 0}, {0, 1}}) {
            if (i + di >= grid.nu || j + dj >= grid.nv) continue;
            const std::uint32_t b = cells[(j + dj) * grid.nu + i + di];
            if (b == kNoTexel || a == b) continue;
            pairs.push_back({a, b});
            const vec3 from = positions[a] + lift * normals[a];
            rays.push_back({from, 0.0F, positions[b] + lift * normals[b] - from, 1.0F});
          }
        }
      }
    }
  }
  std::vector<std::uint8_t> blocked(rays.size(), 0);
  if (caster != nullptr) caster->occluded(rays, blocked);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (blocked[k] == 0) sets.join(pairs[k][0], pairs[k][1]);
  }
  std::vector<std::uint32_t> count(positions.size(), 0);
  for (std::uint32_t i = 0; i < positions.size(); ++i) ++count[sets.find(i)];
  std::vector<std::uint32_t> region(positions.size(), 0);
  const auto small = static_cast<std::uint32_t>(positions.size());
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const std::uint32_t root = sets.find(i);
    region[i] = count[root] >= kLeastCells ? root : small;
  }
  return region;
}

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#include "core/geometry/weld.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/math/rng.h"

namespace soffit::geometry {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

bool finite(const vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Chains of point indices by cell of a uniform grid, cells hashed.
class PointGrid {
 public:
  PointGrid(std::size_t points, double cell)
      : inverse_cell_(1.0 / cell),
        mask_(std::bit_ceil(2 * points + 1) - 1),
        head_(mask_ + 1, kNone),
        next_(points, kNone) {}

  [[nodiscard]] std::int64_t cellOf(double coordinate) const {
    return static_cast<std::int64_t>(std::floor(coordinate * inverse_cell_));
  }
  void insert(std::uint32_t point, const vec3& p) {
    std::uint32_t& head = head_[slot(cellOf(p.x), cellOf(p.y), cellOf(p.z))];
    next_[point] = head;
    head = point;
  }
  // The lowest index within `reach` of p, or kNone.
  [[nodiscard]] std::uint32_t find(const vec3& p, double reach,
                                   std::span<const vec3> positions) const {
    std::uint32_t best = kNone;
    for (std::int64_t x = cellOf(p.x - reach); x <= cellOf(p.x + reach); ++x) {
      for (std::int64_t y = cellOf(p.y - reach); y <= cellOf(p.y + reach); ++y) {
        for (std::int64_t z = cellOf(p.z - reach); z <= cellOf(p.z + reach); ++z) {
          for (std::uint32_t i = head_[slot(x, y, z)]; i != kNone; i = next_[i]) {
            const dvec3 d = dvec3(positions[i]) - dvec3(p);
            if (i < best && glm::dot(d, d) <= reach * reach) best = i;
          }
        }
      }
    }
    return best;
  }

 private:
  [[nodiscard]] std::size_t slot(std::int64_t x, std::int64_t y, std::int64_t z) const {
    std::uint64_t h = mixBits(static_cast<std::uint64_t>(x));
    h = mixBits(h ^ static_cast<std::uint64_t>(y));
    return mixBits(h ^ static_cast<std::uint64_t>(z)) & mask_;
  }

  double inverse_cell_;
  std::size_t mask_;
  std::vector<std::uint32_t> head_;
  std::vector<std::uint32_t> next_;
};

std::uint64_t hashBits(const vec3& p) {
  // + 0 makes the two zeros one.
  const auto word = [](float f) { return std::uint64_t{std::bit_cast<std::uint32_t>(f + 0.0F)}; };
  return mixBits(mixBits(word(p.x) | (word(p.y) << 32U)) ^ word(p.z));
}

// Equal coordinates only. Most copies in a file are exact, and this is several times faster than
// a search by distance.
std::vector<std::uint32_t> weldEqual(std::span<const vec3> positions) {
  const std::size_t mask = std::bit_ceil(2 * positions.size() + 1) - 1;
  std::vector<std::uint32_t> slots(mask + 1, kNone);
  std::vector<std::uint32_t> first(positions.size());
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    first[i] = i;
    if (!finite(positions[i])) continue;
    std::size_t slot = hashBits(positions[i]) & mask;
    while (slots[slot] != kNone && positions[slots[slot]] != positions[i]) slot = (slot + 1) & mask;
    if (slots[slot] == kNone) slots[slot] = i;
    first[i] = slots[slot];
  }
  return first;
}

}  // namespace

float weldTolerance(const Box& bounds) {
  if (bounds.empty()) return 0.0F;
  const vec3 reach = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi));
  return 0x1p-22F * std::max({reach.x, reach.y, reach.z});
}

std::vector<std::uint32_t> weldPositions(std::span<const vec3> positions, float tolerance) {
  std::vector<std::uint32_t> first = weldEqual(positions);
  if (!(tolerance > 0.0F)) return first;
  const double reach = tolerance;
  // Wide cells: a point's reach then seldom crosses into a second one.
  PointGrid grid(positions.size(), 16.0 * reach);
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    if (first[i] != i) {
      first[i] = first[first[i]];
      continue;
    }
    if (!finite(positions[i])) continue;
    const std::uint32_t other = grid.find(positions[i], reach, positions);
    if (other == kNone) {
      grid.insert(i, positions[i]);
    } else {
      first[i] = other;
    }
  }
  return first;
}

}  // namespace soffit::geometry

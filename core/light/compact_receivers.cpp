// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "core/light/receivers.h"

namespace soffit::light {
namespace {

constexpr std::uint32_t kCluster = 256;

/// m per unit of normal: how far apart points may lie before it is better to mix normals.
constexpr float kNormalScale = 0.2F;

class KdSplit {
 public:
  KdSplit(std::span<const vec3> positions, std::span<const vec3> normals,
          std::vector<std::uint32_t>& order)
      : positions_(positions), normals_(normals), order_(order) {}

  /// Orders [begin, end) so that each run of 16 and each run of 256 is compact.
  void split(std::uint32_t begin, std::uint32_t end) const {
    const std::uint32_t count = end - begin;
    if (count <= Receivers::kGroup) return;
    const std::uint32_t unit = count > kCluster ? kCluster : Receivers::kGroup;
    const std::uint32_t units = (count + unit - 1) / unit;
    const std::uint32_t middle = begin + units / 2 * unit;
    const std::size_t axis = widestAxis(begin, end);
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const float ka = key(a, axis);
                       const float kb = key(b, axis);
                       return ka < kb || (ka == kb && a < b);
                     });
    split(begin, middle);
    split(middle, end);
  }

 private:
  [[nodiscard]] float key(std::uint32_t point, std::size_t axis) const {
    const int a = static_cast<int>(axis);
    return a < 3 ? positions_[point][a] : kNormalScale * normals_[point][a - 3];
  }

  [[nodiscard]] std::size_t widestAxis(std::uint32_t begin, std::uint32_t end) const {
    Box place;
    Box look;
    for (std::uint32_t i = begin; i < end; ++i) {
      place.add(positions_[order_[i]]);
      look.add(normals_[order_[i]]);
    }
    const vec3 p = place.size();
    const vec3 n = kNormalScale * look.size();
    const std::array<float, 6> extent{p.x, p.y, p.z, n.x, n.y, n.z};
    return static_cast<std::size_t>(std::max_element(extent.begin(), extent.end()) -
                                    extent.begin());
  }

  std::span<const vec3> positions_;
  std::span<const vec3> normals_;
  std::vector<std::uint32_t>& order_;
};

}  // namespace

Receivers makeCompactReceivers(std::span<const vec3> positions, std::span<const vec3> normals) {
  const auto count = static_cast<std::uint32_t>(positions.size());
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  KdSplit(positions, normals, order).split(0, count);
  std::vector<std::uint32_t> offsets(1, 0U);
  while (offsets.back() < count) offsets.push_back(std::min(count, offsets.back() + kCluster));
  return makeReceivers(positions, normals, order, offsets);
}

}  // namespace soffit::light

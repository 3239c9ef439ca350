// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/shaft.h"
#include "core/math/box.h"
#include "core/math/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soffit::light {

/// A convex planar piece of the static geometry that may stand between a light and a point.
/// Three or four corners, counter-clockwise seen from the front.
struct Blocker {
  std::array<vec3, 4> corners{};
  std::uint8_t count = 3;
  bool solid = false;  ///< face of a closed, outward-wound solid: only its front blocks
  vec3 normal{0.0F};   ///< unit, toward the front

  [[nodiscard]] std::span<const vec3> outline() const { return {corners.data(), count}; }
  [[nodiscard]] Box bounds() const {
    Box box;
    for (const vec3& c : outline()) box.add(c);
    return box;
  }
};

/// Static blockers in a bounding-volume hierarchy that is asked with shafts. Immutable.
class Blockers {
 public:
  Blockers() = default;
  explicit Blockers(std::vector<Blocker> blockers);

  [[nodiscard]] const Blocker& operator[](std::uint32_t i) const { return blockers_[i]; }
  [[nodiscard]] std::size_t size() const { return blockers_.size(); }
  [[nodiscard]] const Box& bounds() const { return bounds_; }

  /// Appends the indices of all blockers that are not certainly outside the shaft.
  void collect(const Shaft& shaft, std::vector<std::uint32_t>& out) const;

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< leaf: first blocker; inner: right child (left is next)
    std::uint32_t count = 0;  ///< leaf: number of blockers; inner: 0
  };
  void build(std::uint32_t begin, std::uint32_t end, std::vector<Box>& boxes);

  std::vector<Blocker> blockers_;
  std::vector<Node> nodes_;
  Box bounds_;
};

}  // namespace soffit::light

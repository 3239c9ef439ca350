// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/light/blocker_lanes.h"
#include "core/light/box_tree.h"
#include "core/light/light_mask.h"
#include "core/light/shaft.h"
#include "core/math/box.h"
#include "core/math/vec.h"

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

/// A blocker in the form the kernels take.
MaskBlocker maskBlocker(const Blocker& blocker);

/// Blockers in a hierarchy, asked with shafts. Immutable.
class Blockers {
 public:
  Blockers() = default;
  explicit Blockers(std::span<const Blocker> blockers);
  explicit Blockers(std::span<const MaskBlocker> blockers);

  [[nodiscard]] std::size_t size() const { return size_; }

  /// Appends what may stand in the shaft's way: the blockers that filterBlock() keeps.
  void collect(const Shaft& shaft, BlockerLanes& out) const;

 private:
  std::size_t size_ = 0;
  bool five_ = false;                 ///< whether any has five corners
  std::vector<BlockerBlock> blocks_;  ///< in the order of the tree
  BoxTree tree_;                      ///< of the blocks
};

}  // namespace soffit::light

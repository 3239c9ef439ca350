// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

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

/// Static blockers, asked with shafts. Immutable.
class Blockers {
 public:
  Blockers() = default;
  explicit Blockers(std::span<const Blocker> blockers);

  [[nodiscard]] std::size_t size() const { return items_.size(); }

  /// Appends the parts of the hierarchy that are neither certainly outside the shaft nor turned
  /// away from all of its `from` box: the place to start from for all shafts within it.
  void collect(const Shaft& shaft, std::vector<BoxTree::Part>& out) const;

  /// Who stands between a group of receivers and a light.
  struct Found {
    std::vector<const MaskBlocker*> whole;  ///< entirely in front of `cut`
    std::vector<const MaskBlocker*> cut;    ///< partly: to be clipped
  };
  /// Replaces `out` by all blockers of `parts` that are neither certainly outside the shaft nor,
  /// for solids, turned away from every point of `receivers`.
  /// cut: (n, d) of a plane of which only the side n.x > d counts; null for none.
  void find(std::span<const BoxTree::Part> parts, const Shaft& shaft, const Box& receivers,
            const vec4* cut, Found& out) const;

 private:
  std::vector<MaskBlocker> items_;  ///< in the order of the tree
  std::vector<CullBlock> blocks_;   ///< the same, 16 by 16
  BoxTree tree_;                    ///< of the blocks
};

}  // namespace soffit::light

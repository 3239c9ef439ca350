// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/light/blocker_lanes.h"
#include "core/math/box.h"
#include "core/math/vec.h"

namespace soffit::light {

/// 16 blockers of the static geometry, one column each; unused columns have no corners.
struct BlockerBlock {
  alignas(64) std::array<std::array<float, BlockerLanes::kBlock>, BlockerRow::kRows> rows{};
};

/// 16 boxes, structure of arrays; lanes that were not set are outside of everything.
struct BoxBlock {
  static constexpr std::size_t kSize = 16;
  using Lanes = std::array<float, kSize>;
  BoxBlock() {
    lo.fill(filled(1e30F));
    hi.fill(filled(1e30F));
  }
  void set(std::size_t k, const Box& box) {
    for (std::size_t a = 0; a < 3; ++a) {
      lo[a][k] = box.lo[static_cast<int>(a)];
      hi[a][k] = box.hi[static_cast<int>(a)];
    }
  }
  alignas(64) std::array<Lanes, 3> lo, hi;

 private:
  static Lanes filled(float value) {
    Lanes lanes;
    lanes.fill(value);
    return lanes;
  }
};

/// Bit k is set unless box k lies outside a plane (all of it n.x >= w).
std::uint32_t cullBoxes(const BoxBlock& block, std::span<const vec4> planes);

/// What a blocker must meet to stand between a box of receivers and a light.
struct BlockerFilter {
  Box hull;                      ///< outside are those that do not reach into it
  std::span<const vec4> planes;  ///< outside is where all corners have n.x >= w
  Box receivers;
  Box light;
  const vec4* cut = nullptr;  ///< (n, d): only what lies at n.x > d counts; null for none
};

/// Appends the blockers that may hide a part of the light from a receiver. Left out are those
/// outside the hull or a plane; those whose own plane does not separate a receiver from a place of
/// the light, faces of solids only with the receiver in front; and those that reach behind the cut,
/// whose bits are returned. five: whether any may have five corners.
std::uint32_t filterBlock(const BlockerBlock& in, bool five, const BlockerFilter& filter,
                          BlockerLanes& out);

/// The same for columns [first, first + 16) of a table; columns past its end are left out.
std::uint32_t filterLanes(const BlockerLanes& in, std::size_t first, const BlockerFilter& filter,
                          BlockerLanes& out);

}  // namespace soffit::light

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/math/box.h"
#include "core/math/vec.h"

namespace soffit::light {

/// 16 blockers, structure of arrays: lane k belongs to blocker k.
struct CullBlock {
  static constexpr std::size_t kSize = 16;
  static constexpr std::size_t kCorners = 4;
  using Lanes = std::array<float, kSize>;

  alignas(64) std::array<Lanes, kCorners> x{}, y{}, z{};  ///< corners; triangles repeat one
  alignas(64) Lanes nx{}, ny{}, nz{};                     ///< front of solids; 0 for sheets
  alignas(64) Lanes d{};                                  ///< of that plane; -1 for sheets
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

/// A bit per blocker.
struct CullResult {
  std::uint32_t whole = 0;  ///< survivors entirely in front of the cut
  std::uint32_t cut = 0;    ///< survivors that reach behind it
};

/// Blockers survive unless they lie outside a plane (all corners n.x >= w), or are the face of a
/// solid that shows its back to the whole box `receivers`.
/// cut: (n, d), in front is n.x > d; null: all survivors count as whole.
CullResult cullBlock(const CullBlock& block, std::span<const vec4> planes, const Box& receivers,
                     const vec4* cut);

}  // namespace soffit::light

// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soffit::transfer {

/// Gather rays as sparse sums over slots: value = scale * sum rays_k x[slot_k], the irradiance
/// that radiosity x (lux) sends to the point.
///
/// An entry is the slot x 16, which is the offset in bytes of its vec4. Entries come in groups of
/// four that the same number of rays meet: the number's code stands in the low bits of the first,
/// so that a group is four sums and one product. Up to three single entries of one ray each follow
/// the groups.
struct GatherLists {
  using Entry = std::uint32_t;
  static constexpr std::size_t kGroup = 4;
  /// Rays by code. Other numbers are sums of these.
  static constexpr std::array<float, 16> kRays = {1, 2,  3,  4,  5,  6,  7,  8,
                                                  9, 10, 12, 16, 24, 32, 48, 64};
  static constexpr std::uint32_t kMostSlots = 1U << 28U;
  struct List {
    std::uint64_t first = 0;  ///< into entries
    std::uint32_t groups = 0;
    std::uint32_t rest = 0;  ///< entries of one ray after the groups, 0 to 3
    float scale = 0.0F;      ///< 1 / number of rays
    std::uint32_t padding = 0;
  };
  std::vector<Entry> entries;
  std::vector<List> lists;

  /// Calls f(slot, rays) for the entries of a list, in no order.
  template <class F>
  void forEachEntry(const List& list, const F& f) const {
    const Entry* entry = entries.data() + list.first;
    for (std::uint32_t g = 0; g < list.groups; ++g) {
      const auto rays = static_cast<std::uint32_t>(kRays[entry[0] & 15U]);
      for (std::size_t k = 0; k < kGroup; ++k) f(*entry++ >> 4U, rays);
    }
    for (std::uint32_t k = 0; k < list.rest; ++k) f(*entry++ >> 4U, 1U);
  }

  /// Appends the list of a point: `slots` as traceHemisphere gives them (kNoTexel: dark), sorted
  /// in place; below kMostSlots.
  void append(std::span<std::uint32_t> slots);
  /// Appends all lists of another set.
  void append(const GatherLists& other);
  [[nodiscard]] std::size_t bytes() const {
    return entries.size() * sizeof(Entry) + lists.size() * sizeof(List);
  }
};

}  // namespace soffit::transfer

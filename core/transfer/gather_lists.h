// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/receivers.h"
#include "core/math/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soffit::transfer {

/// Gather rays as sparse sums over texels: value = scale * sum count_k x[slot_k], the irradiance
/// that radiosity x (lux) sends to the point.
///
/// Slots are divided into pages of kPage. Entries come in groups of four of the same page, so that a
/// list is two loops without another branch; a dark page costs one test per group. An entry is two
/// bytes: the slot's place in the page x 16, which is the offset in bytes of its vec4, plus a code
/// for how many rays ended there. Three quarters of the entries are single rays (code 0): groups of
/// nothing else come first and need neither code nor product.
struct GatherLists {
  using Entry = std::uint16_t;
  static constexpr std::uint32_t kPage = 4096;
  static constexpr std::size_t kGroup = 4;
  /// Rays by code. Other numbers are sums of these; entries of none fill up a group.
  static constexpr std::array<float, 16> kRays = {1, 2,  3,  4,  5,  6,  7,  8,
                                                  9, 10, 12, 16, 24, 32, 64, 0};
  struct List {
    std::uint32_t first_group = 0;
    std::uint32_t single = 0;  ///< groups of single rays
    std::uint32_t mixed = 0;   ///< groups after those
    float scale = 0.0F;        ///< 1 / number of rays
  };
  std::vector<Entry> entries;        ///< kGroup per group
  std::vector<std::uint16_t> pages;  ///< per group
  std::vector<List> lists;

  /// Calls f(slot, rays) for the entries of a list, in no order.
  template <class F>
  void forEachEntry(const List& list, const F& f) const {
    const std::size_t end = std::size_t{list.first_group} + list.single + list.mixed;
    for (std::size_t k = kGroup * list.first_group; k < kGroup * end; ++k) {
      const auto rays = static_cast<std::uint32_t>(kRays[entries[k] & 15U]);
      if (rays > 0) f(pages[k / kGroup] * kPage + (entries[k] >> 4U), rays);
    }
  }

  /// Appends the list of a point: `slots` as traceHemisphere gives them (kNoTexel: dark), sorted
  /// in place. At most 2^28 slots.
  void append(std::span<std::uint32_t> slots);
  /// Appends all lists of another set.
  void append(const GatherLists& other);
  [[nodiscard]] std::size_t bytes() const {
    return entries.size() * sizeof(Entry) + pages.size() * sizeof(std::uint16_t) +
           lists.size() * sizeof(List);
  }
};

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/receivers.h"
#include "core/math/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soffit::transfer {

/// Which cluster a slot belongs to, and where clusters begin.
struct SlotClusters {
  std::vector<std::uint32_t> cluster_of;  ///< per slot
  std::vector<std::uint32_t> begin;       ///< per cluster
};
SlotClusters slotClusters(const light::Receivers& receivers);

/// Gather rays as sparse sums over texels: value = scale * sum count_k x[slot_k], the irradiance
/// that radiosity x (lux) sends to the point.
///
/// Slots are divided into pages of kPage; a list is a run of entries for each page that it sees, so
/// that a dark page costs one test. An entry is two bytes: the slot's place in the page x 16, which
/// is the offset in bytes of its vec4, plus a code for how many rays ended there. Three quarters of
/// the entries are single rays, which come first in a run: they need neither code nor product.
struct GatherLists {
  using Entry = std::uint16_t;
  static constexpr std::uint32_t kPage = 4096;
  /// Rays by code. Other numbers are sums of these.
  static constexpr std::array<float, 16> kRays = {1, 2,  3,  4,  5,  6,  7,   8,
                                                  9, 10, 12, 16, 24, 32, 64, 256};
  struct Run {
    std::uint16_t page = 0;
    std::uint16_t single = 0;  ///< entries of one ray
    std::uint16_t many = 0;    ///< entries of more, after those
  };
  struct List {
    std::uint32_t first_run = 0;
    std::uint32_t run_count = 0;
    std::uint32_t first_entry = 0;
    float scale = 0.0F;  ///< 1 / number of rays
  };
  std::vector<Entry> entries;
  std::vector<Run> runs;
  std::vector<List> lists;

  /// Calls f(slot, rays) for the entries of a list, page after page in ascending order.
  template <class F>
  void forEachEntry(const List& list, const F& f) const {
    const Entry* entry = entries.data() + list.first_entry;
    for (std::uint32_t r = list.first_run; r < list.first_run + list.run_count; ++r) {
      for (std::uint32_t k = 0; k < std::uint32_t{runs[r].single} + runs[r].many; ++k, ++entry) {
        f(runs[r].page * kPage + (*entry >> 4U), static_cast<std::uint32_t>(kRays[*entry & 15U]));
      }
    }
  }

  /// Appends the list of a point: `slots` as traceHemisphere gives them (kNoTexel: dark), sorted
  /// in place. At most 2^28 slots and 2^20 rays.
  void append(std::span<std::uint32_t> slots);
  void append(std::span<std::uint32_t> slots, const SlotClusters& /*clusters*/) { append(slots); }
  /// Appends all lists of another set.
  void append(const GatherLists& other);
  [[nodiscard]] std::size_t bytes() const {
    return entries.size() * sizeof(Entry) + runs.size() * sizeof(Run) +
           lists.size() * sizeof(List);
  }
};

}  // namespace soffit::transfer

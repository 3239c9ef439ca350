// SPDX-License-Identifier: MIT
#include "core/transfer/gather_lists.h"

#include "core/transfer/texels.h"

#include <algorithm>
#include <cassert>

namespace soffit::transfer {
namespace {

constexpr std::size_t kCodes = GatherLists::kRays.size();

/// The slots of a list by how many rays meet them.
class ByRays {
 public:
  /// As few of kRays as the greedy choice takes, which is exact because the smallest is 1.
  void add(std::uint32_t slot, std::size_t rays) {
    for (std::size_t code = kCodes; code-- > 0;) {
      const auto count = static_cast<std::size_t>(GatherLists::kRays[code]);
      for (; rays >= count; rays -= count) slots_[code].push_back(slot);
    }
  }

  /// What does not fill a group is taken for one step less, and the rest of it for what that is.
  void fillGroups() {
    for (std::size_t code = kCodes; code-- > 1;) {
      while (slots_[code].size() % GatherLists::kGroup != 0) {
        const std::uint32_t slot = slots_[code].back();
        slots_[code].pop_back();
        slots_[code - 1].push_back(slot);
        add(slot,
            static_cast<std::size_t>(GatherLists::kRays[code] - GatherLists::kRays[code - 1]));
      }
    }
  }

  [[nodiscard]] const std::vector<std::uint32_t>& of(std::size_t code) const {
    return slots_[code];
  }

 private:
  std::array<std::vector<std::uint32_t>, kCodes> slots_;
};

}  // namespace

void GatherLists::append(std::span<std::uint32_t> slots) {
  std::sort(slots.begin(), slots.end());
  ByRays by_rays;
  for (std::size_t i = 0; i < slots.size() && slots[i] != kNoTexel;) {
    assert(slots[i] < kMostSlots);
    const std::size_t begin = i;
    while (i < slots.size() && slots[i] == slots[begin]) ++i;
    by_rays.add(slots[begin], i - begin);
  }
  by_rays.fillGroups();
  List list;
  list.first = entries.size();
  list.scale = slots.empty() ? 0.0F : 1.0F / static_cast<float>(slots.size());
  for (std::size_t code = kCodes; code-- > 0;) {
    const std::vector<std::uint32_t>& of = by_rays.of(code);
    for (std::size_t k = 0; k < of.size(); ++k) {
      const bool leads = k % kGroup == 0;
      entries.push_back(of[k] << 4U | (leads ? static_cast<std::uint32_t>(code) : 0U));
    }
    list.groups += static_cast<std::uint32_t>(of.size() / kGroup);
    if (code == 0) list.rest = static_cast<std::uint32_t>(of.size() % kGroup);
  }
  lists.push_back(list);
}

void GatherLists::append(const GatherLists& other) {
  const std::uint64_t shift = entries.size();
  entries.insert(entries.end(), other.entries.begin(), other.entries.end());
  for (List l : other.lists) {
    l.first += shift;
    lists.push_back(l);
  }
}

}  // namespace soffit::transfer

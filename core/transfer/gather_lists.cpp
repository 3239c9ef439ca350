// SPDX-License-Identifier: MIT
#include "core/transfer/gather_lists.h"

#include "core/transfer/texels.h"

#include <algorithm>
#include <cassert>

namespace soffit::transfer {
namespace {

/// Appends the entries of one slot: as few of kRays as the greedy choice takes, which is exact
/// because the smallest is 1.
void appendSlot(std::uint32_t place, std::size_t rays, std::vector<GatherLists::Entry>& single,
                std::vector<GatherLists::Entry>& many) {
  for (std::size_t code = GatherLists::kRays.size(); code-- > 0;) {
    const auto count = static_cast<std::size_t>(GatherLists::kRays[code]);
    for (; rays >= count; rays -= count) {
      (code == 0 ? single : many)
          .push_back(static_cast<GatherLists::Entry>(place << 4U | static_cast<std::uint32_t>(code)));
    }
  }
}

}  // namespace

void GatherLists::append(std::span<std::uint32_t> slots) {
  std::sort(slots.begin(), slots.end());
  List list;
  list.first_run = static_cast<std::uint32_t>(runs.size());
  list.first_entry = static_cast<std::uint32_t>(entries.size());
  list.scale = slots.empty() ? 0.0F : 1.0F / static_cast<float>(slots.size());
  std::vector<Entry> many;
  for (std::size_t i = 0; i < slots.size() && slots[i] != kNoTexel;) {
    const std::uint32_t page = slots[i] / kPage;
    assert(page <= 0xffffU);
    const std::size_t before = entries.size();
    many.clear();
    while (i < slots.size() && slots[i] != kNoTexel && slots[i] / kPage == page) {
      std::size_t j = i;
      while (j < slots.size() && slots[j] == slots[i]) ++j;
      appendSlot(slots[i] % kPage, j - i, entries, many);
      i = j;
    }
    runs.push_back({static_cast<std::uint16_t>(page),
                    static_cast<std::uint16_t>(entries.size() - before),
                    static_cast<std::uint16_t>(many.size())});
    entries.insert(entries.end(), many.begin(), many.end());
  }
  list.run_count = static_cast<std::uint32_t>(runs.size()) - list.first_run;
  lists.push_back(list);
}

void GatherLists::append(const GatherLists& other) {
  const auto entry_shift = static_cast<std::uint32_t>(entries.size());
  const auto run_shift = static_cast<std::uint32_t>(runs.size());
  entries.insert(entries.end(), other.entries.begin(), other.entries.end());
  runs.insert(runs.end(), other.runs.begin(), other.runs.end());
  for (List l : other.lists) {
    l.first_run += run_shift;
    l.first_entry += entry_shift;
    lists.push_back(l);
  }
}

SlotClusters slotClusters(const light::Receivers& receivers) {
  SlotClusters out;
  out.cluster_of.resize(receivers.slotCount());
  for (std::uint32_t c = 0; c < receivers.clusters.size(); ++c) {
    const light::Receivers::Cluster& cluster = receivers.clusters[c];
    out.begin.push_back(cluster.begin);
    std::fill(out.cluster_of.begin() + cluster.begin, out.cluster_of.begin() + cluster.end, c);
  }
  return out;
}

}  // namespace soffit::transfer

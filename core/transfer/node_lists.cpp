// SPDX-License-Identifier: MIT
#include "core/transfer/node_lists.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace soffit::transfer {
namespace {

std::int16_t quantize(double sum) {
  return static_cast<std::int16_t>(std::clamp(std::lround(sum / static_cast<double>(NodeLists::kStep)), -32767L, 32767L));
}

std::vector<NodeLists::Entry> entriesOf(const GatherLists& lists, const GatherLists::List& list, const Nodes& nodes) {
  // Slots ascend within a list, and patches are ranges of slots: equal patches are neighbours.
  std::vector<NodeLists::Entry> out;
  double phi1 = 0.0;
  double phi2 = 0.0;
  std::uint32_t count = 0;
  std::uint32_t patch = 0xffffffffU;
  const auto flush = [&] {
    if (count == 0) return;
    out.push_back({static_cast<std::uint16_t>(patch), static_cast<std::uint16_t>(std::min(count, 65535U)),
                   quantize(phi1), quantize(phi2)});
    count = 0;
    phi1 = 0.0;
    phi2 = 0.0;
  };
  for (std::uint32_t b = list.first_block; b < list.first_block + list.block_count; ++b) {
    const GatherLists::Block& block = lists.blocks[b];
    for (std::uint32_t e = block.first; e < block.first + block.count; ++e) {
      const std::uint32_t slot = block.base + lists.entries[e].local;
      if (nodes.patch_of[slot] != patch) {
        flush();
        patch = nodes.patch_of[slot];
      }
      count += lists.entries[e].count;
      phi1 += lists.entries[e].count * static_cast<double>(nodes.phi[slot].x);
      phi2 += lists.entries[e].count * static_cast<double>(nodes.phi[slot].y);
    }
  }
  flush();
  return out;
}

}  // namespace

NodeLists makeNodeLists(const GatherLists& lists, const Nodes& nodes) {
  NodeLists out;
  for (const Nodes::Patch& p : nodes.patches) {
    out.first_function.push_back(p.first);
    out.function_count.push_back(static_cast<std::uint8_t>(p.count));
  }
  std::vector<std::vector<NodeLists::Entry>> made(lists.lists.size());
  parallelFor(made.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) made[k] = entriesOf(lists, lists.lists[k], nodes);
  });
  for (std::size_t k = 0; k < made.size(); ++k) {
    out.lists.push_back({static_cast<std::uint32_t>(out.entries.size()), static_cast<std::uint32_t>(made[k].size()),
                         lists.lists[k].scale});
    out.entries.insert(out.entries.end(), made[k].begin(), made[k].end());
  }
  return out;
}

}  // namespace soffit::transfer

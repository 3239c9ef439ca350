// SPDX-License-Identifier: MIT
#include "core/transfer/node_lists.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace soffit::transfer {
namespace {

constexpr long kMost = 127;  // what a byte with a sign holds

/// Sums over the rays that end in one patch.
struct Sums {
  std::uint32_t patch = 0;
  long count = 0;
  double phi1 = 0.0;
  double phi2 = 0.0;
};

long steps(double sum) { return std::lround(sum / static_cast<double>(NodeLists::kStep)); }

/// Takes off as much as one entry holds.
std::int8_t take(long& rest) {
  const long part = std::clamp(rest, -kMost, kMost);
  rest -= part;
  return static_cast<std::int8_t>(part);
}

void append(const Sums& sums, std::uint32_t gap, std::vector<NodeLists::Entry>& out) {
  for (; gap > 255; gap -= 255) out.push_back({255, 0, 0, 0});
  std::array<long, 3> rest = {sums.count, steps(sums.phi1), steps(sums.phi2)};
  while (rest != std::array<long, 3>{}) {
    out.push_back({static_cast<std::uint8_t>(std::exchange(gap, 0U)), take(rest[0]), take(rest[1]),
                   take(rest[2])});
  }
}

std::vector<NodeLists::Entry> entriesOf(const GatherLists& lists, const GatherLists::List& list,
                                        const Nodes& nodes) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> taps;  // slot, rays
  lists.forEachEntry(list, [&](std::uint32_t slot, std::uint32_t rays) {
    taps.emplace_back(slot, rays);
  });
  std::sort(taps.begin(), taps.end());
  std::vector<NodeLists::Entry> out;
  std::uint32_t before = 0;
  Sums sums;
  const auto flush = [&] {
    if (sums.count == 0) return;
    append(sums, sums.patch - before, out);
    before = sums.patch;
  };
  // Patches are ranges of slots: equal patches are neighbours.
  for (const auto& [slot, rays] : taps) {
    if (nodes.patch_of[slot] != sums.patch) {
      flush();
      sums = {.patch = nodes.patch_of[slot]};
    }
    sums.count += rays;
    sums.phi1 += rays * static_cast<double>(nodes.phi[slot].x);
    sums.phi2 += rays * static_cast<double>(nodes.phi[slot].y);
  }
  flush();
  return out;
}

}  // namespace

NodeLists makeNodeLists(const GatherLists& lists, const Nodes& nodes) {
  NodeLists out;
  std::vector<std::vector<NodeLists::Entry>> made(lists.lists.size());
  parallelFor(made.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) made[k] = entriesOf(lists, lists.lists[k], nodes);
  });
  for (std::size_t k = 0; k < made.size(); ++k) {
    out.lists.push_back({static_cast<std::uint32_t>(out.entries.size()),
                         static_cast<std::uint32_t>(made[k].size()), lists.lists[k].scale});
    out.entries.insert(out.entries.end(), made[k].begin(), made[k].end());
  }
  return out;
}

}  // namespace soffit::transfer

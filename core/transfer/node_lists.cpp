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
constexpr std::uint32_t kMostGap = 0xffff;
/// Sums of phi within so many standard deviations of 0 count as chance.
constexpr double kChance = 1.5;

/// Sums over the rays that end in one patch.
struct Sums {
  std::uint32_t patch = 0;
  double count = 0.0;
  double phi1 = 0.0;
  double phi2 = 0.0;
};

long steps(double sum, double count) {
  if (sum * sum <= kChance * kChance * count) return 0;
  return std::lround(sum / static_cast<double>(NodeLists::kStep));
}

/// Takes off as much as one entry holds.
std::int8_t take(long& rest) {
  const long part = std::clamp(rest, -kMost, kMost);
  rest -= part;
  return static_cast<std::int8_t>(part);
}

/// Returns whether the patch got an entry.
bool append(const Sums& sums, std::uint32_t gap, std::vector<NodeLists::Entry>& out) {
  std::array<long, 2> rest = {steps(sums.phi1, sums.count), steps(sums.phi2, sums.count)};
  if (rest == std::array<long, 2>{}) return false;
  for (; gap > kMostGap; gap -= kMostGap) out.push_back({kMostGap, 0, 0});
  while (rest != std::array<long, 2>{}) {
    out.push_back(
        {static_cast<std::uint16_t>(std::exchange(gap, 0U)), take(rest[0]), take(rest[1])});
  }
  return true;
}

/// The rays of one list by patches.
struct Made {
  std::vector<std::uint32_t> patches;  ///< per ray
  std::vector<NodeLists::Entry> entries;
};

Made entriesOf(const GatherLists& lists, const GatherLists::List& list, const Nodes& nodes) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> taps;  // slot, rays
  lists.forEachEntry(
      list, [&](std::uint32_t slot, std::uint32_t rays) { taps.emplace_back(slot, rays); });
  std::sort(taps.begin(), taps.end());
  Made out;
  std::uint32_t before = 0;
  Sums sums;
  const auto flush = [&] {
    if (append(sums, sums.patch - before, out.entries)) before = sums.patch;
  };
  // Patches are ranges of slots: equal patches are neighbours.
  for (const auto& [slot, rays] : taps) {
    if (nodes.patch_of[slot] != sums.patch) {
      flush();
      sums = {.patch = nodes.patch_of[slot]};
    }
    out.patches.insert(out.patches.end(), rays, sums.patch);
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
  std::vector<Made> made(lists.lists.size());
  parallelFor(made.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) made[k] = entriesOf(lists, lists.lists[k], nodes);
  });
  for (std::size_t k = 0; k < made.size(); ++k) {
    const std::vector<NodeLists::Entry>& entries = made[k].entries;
    out.lists.push_back({static_cast<std::uint32_t>(out.entries.size()),
                         static_cast<std::uint32_t>(entries.size()), lists.lists[k].scale});
    out.entries.insert(out.entries.end(), entries.begin(), entries.end());
    out.constants.append(made[k].patches);
    out.constants.lists.back().scale = lists.lists[k].scale;
  }
  return out;
}

}  // namespace soffit::transfer

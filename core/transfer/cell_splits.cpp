// SPDX-License-Identifier: MIT
#include "core/transfer/cell_splits.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::transfer {
namespace {

constexpr std::size_t kProbes = CellOutlook::kProbes;
using Mean = std::array<double, kProbes>;

/// Fine cells of one base cell that light reaches.
struct Group {
  std::array<std::size_t, 16> cells{};
  std::size_t count = 0;
  void add(std::size_t cell) { cells[count++] = cell; }
  [[nodiscard]] std::span<const std::size_t> all() const { return {cells.data(), count}; }
};

Mean meanOf(const SplitGrid& grid, std::span<const std::size_t> cells) {
  Mean mean{};
  double area = 0.0;
  for (const std::size_t i : cells) {
    const double a = grid.cut->cells[i].area;
    area += a;
    for (std::size_t k = 0; k < kProbes; ++k) mean[k] += a * grid.outlook[i].distance[k];
  }
  if (area > 0.0) {
    for (double& m : mean) m /= area;
  }
  return mean;
}

double apart(const CellOutlook& cell, const Mean& mean) {
  double sum = 0.0;
  for (std::size_t k = 0; k < kProbes; ++k) sum += std::abs(cell.distance[k] - mean[k]);
  return sum / kProbes;
}

/// How unlike each other the cells of a group are: their mean deviation relative to the mean, so
/// that the dark counts nearly as much as the bright, times area.
double unlikeness(const SplitGrid& grid, const Group& group) {
  constexpr double kDark = 25.0;  // below this it is so dark that nobody asks
  const Mean mean = meanOf(grid, group.all());
  double level = 0.0;
  for (const double m : mean) level += m / kProbes;
  double deviation = 0.0;
  for (std::size_t i = 0; i < group.count; ++i) {
    deviation += grid.cut->cells[group.cells[i]].area * apart(grid.outlook[group.cells[i]], mean);
  }
  return deviation / (level + kDark);
}

/// Two groups that are each as alike as can be: 2-means from the two sides of the mean of the probe
/// that tells most.
std::array<Group, 2> halve(const SplitGrid& grid, const Group& group) {
  const Mean mean = meanOf(grid, group.all());
  Mean spread{};
  for (std::size_t i = 0; i < group.count; ++i) {
    for (std::size_t k = 0; k < kProbes; ++k) {
      spread[k] += std::abs(grid.outlook[group.cells[i]].distance[k] - mean[k]);
    }
  }
  const auto probe =
      static_cast<std::size_t>(std::max_element(spread.begin(), spread.end()) - spread.begin());
  std::array<Group, 2> parts;
  for (std::size_t i = 0; i < group.count; ++i) {
    parts[grid.outlook[group.cells[i]].distance[probe] > mean[probe] ? 1 : 0].add(group.cells[i]);
  }
  for (int round = 0; round < 4 && parts[0].count > 0 && parts[1].count > 0; ++round) {
    const std::array<Mean, 2> means = {meanOf(grid, parts[0].all()), meanOf(grid, parts[1].all())};
    std::array<Group, 2> next;
    for (std::size_t i = 0; i < group.count; ++i) {
      const CellOutlook& cell = grid.outlook[group.cells[i]];
      next[apart(cell, means[1]) < apart(cell, means[0]) ? 1 : 0].add(group.cells[i]);
    }
    if (next[0].count == 0 || next[1].count == 0) break;
    parts = next;
  }
  return parts;
}

constexpr double kForced = 1e300;

/// One more texel in a base cell: groups as they are after it.
struct Step {
  double gain = 0.0;
  std::size_t grid = 0;
  std::size_t base = 0;
  std::uint8_t groups = 1;
  std::array<std::uint8_t, 16> group{};  ///< per fine cell of the base cell, in forEachCell's order
};

std::array<std::uint8_t, 16> numbersOf(const SplitGrid& grid, std::size_t base,
                                       std::span<const Group> groups) {
  std::array<std::uint8_t, 16> out{};
  std::size_t at = 0;
  grid.forEachCell(base, [&](std::size_t cell) {
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const auto end = groups[g].cells.begin() + static_cast<std::ptrdiff_t>(groups[g].count);
      if (std::find(groups[g].cells.begin(), end, cell) != end)
        out[at] = static_cast<std::uint8_t>(g);
    }
    ++at;
  });
  return out;
}

/// The exposed cells of a base cell in pieces that hang together.
std::vector<Group> pieces(const SplitGrid& grid, std::size_t base) {
  const auto nu = static_cast<std::size_t>(grid.layout.nu);
  std::vector<std::size_t> left;
  grid.forEachCell(base, [&](std::size_t cell) {
    if (grid.exposed(cell)) left.push_back(cell);
  });
  const auto joined = [&](std::size_t a, std::size_t b) {
    if (a > b) std::swap(a, b);
    if (grid.outlook[a].cover != grid.outlook[b].cover) return false;  // a gap's light is its own
    if (b == a + 1 && b % nu != 0) return (grid.outlook[a].open & 1U) != 0;
    return b == a + nu && (grid.outlook[a].open & 2U) != 0;
  };
  std::vector<Group> out;
  while (!left.empty()) {
    Group piece;
    piece.add(left.front());
    left.erase(left.begin());
    for (std::size_t k = 0; k < piece.count; ++k) {
      for (auto cell = left.begin(); cell != left.end();) {
        if (joined(piece.cells[k], *cell)) {
          piece.add(*cell);
          cell = left.erase(cell);
        } else {
          ++cell;
        }
      }
    }
    out.push_back(piece);
  }
  return out;
}

/// The splits of one base cell, best first; a later one never gains more than an earlier one, so
/// that they are taken in order. Returns whether light reaches the cell at all.
bool addSteps(const SplitGrid& grid, std::size_t g, std::size_t base, std::vector<Step>& steps) {
  std::vector<Group> groups = pieces(grid, base);
  std::vector<double> error;
  error.reserve(SplitGrid::kMostGroups);
  for (const Group& group : groups)
    error.push_back(group.count > 1 ? unlikeness(grid, group) : 0.0);
  if (groups.size() > 1) {
    // Not a matter of choice.
    steps.push_back({kForced, g, base, static_cast<std::uint8_t>(groups.size()),
                     numbersOf(grid, base, groups)});
  }
  const std::size_t first = steps.size();
  while (!groups.empty() && groups.size() < SplitGrid::kMostGroups) {
    const auto worst =
        static_cast<std::size_t>(std::max_element(error.begin(), error.end()) - error.begin());
    if (error[worst] <= 0.0) break;
    const std::array<Group, 2> parts = halve(grid, groups[worst]);
    if (parts[0].count == 0 || parts[1].count == 0) break;
    const double e0 = unlikeness(grid, parts[0]);
    const double e1 = unlikeness(grid, parts[1]);
    Step step{error[worst] - e0 - e1, g, base, 0, {}};
    if (step.gain <= 0.0) break;
    groups[worst] = parts[0];
    error[worst] = e0;
    groups.push_back(parts[1]);
    error.push_back(e1);
    if (steps.size() > first) step.gain = std::min(step.gain, steps.back().gain);
    step.groups = static_cast<std::uint8_t>(groups.size());
    step.group = numbersOf(grid, base, groups);
    steps.push_back(step);
  }
  return !groups.empty();
}

}  // namespace

std::size_t splitCells(std::span<SplitGrid> grids, std::size_t count) {
  std::vector<std::vector<Step>> by_grid(grids.size());
  std::vector<std::size_t> whole(grids.size(), 0);
  parallelFor(grids.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t g = begin; g < end; ++g) {
      if (grids[g].outlook.empty()) continue;
      for (std::size_t base = 0; base < grids[g].groups.size(); ++base) {
        whole[g] += addSteps(grids[g], g, base, by_grid[g]) ? 1 : 0;
      }
    }
  });
  std::vector<Step> steps;
  std::size_t texels = 0;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    texels += whole[g];
    steps.insert(steps.end(), by_grid[g].begin(), by_grid[g].end());
  }
  std::stable_sort(steps.begin(), steps.end(),
                   [](const Step& a, const Step& b) { return a.gain > b.gain; });
  for (const Step& step : steps) {
    if (texels >= count && step.gain < kForced) break;
    SplitGrid& grid = grids[step.grid];
    texels += step.groups - grid.groups[step.base];
    grid.groups[step.base] = step.groups;
    std::size_t at = 0;
    grid.forEachCell(step.base, [&](std::size_t cell) { grid.group[cell] = step.group[at++]; });
  }
  // A tenth of the light of a whole cell.
  return static_cast<std::size_t>(std::count_if(steps.begin(), steps.end(), [&](const Step& step) {
    const CellGrid& cut = *grids[step.grid].cut;
    const GridLayout& layout = grids[step.grid].layout;
    const double full =
        static_cast<double>(cut.cell.x) * static_cast<double>(cut.cell.y) * layout.ku * layout.kv;
    return step.gain > 0.1 * full;
  }));
}

std::size_t typicalCell(const SplitGrid& grid, std::span<const std::size_t> cells) {
  const Mean mean = meanOf(grid, cells);
  return *std::min_element(cells.begin(), cells.end(), [&](std::size_t a, std::size_t b) {
    return apart(grid.outlook[a], mean) < apart(grid.outlook[b], mean);
  });
}

}  // namespace soffit::transfer

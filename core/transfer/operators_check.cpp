// SPDX-License-Identifier: MIT
#include "core/transfer/operators_check.h"

#include "core/transfer/far_blocks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace soffit::transfer {
namespace {

/// Below 2^100, so that neither sums nor products of a few overflow; not NaN.
bool sane(std::span<const float> values) {
  constexpr std::uint32_t kExponent = 0x7f800000U;
  constexpr std::uint32_t kLimit = (127U + 100U) << 23U;
  std::uint32_t bad = 0;  // without an early exit this is a vector loop
  for (const float v : values) {
    bad |= (std::bit_cast<std::uint32_t>(v) & kExponent) >= kLimit ? 1U : 0U;
  }
  return bad == 0;
}
template <class Vector>
bool saneVectors(const std::vector<Vector>& values) {
  static_assert(sizeof(Vector) == sizeof(float) * static_cast<std::size_t>(Vector::length()));
  return values.empty() || sane({&values[0].x, values.size() * sizeof(Vector) / sizeof(float)});
}

bool below(std::span<const std::uint32_t> values, std::size_t limit) {
  return std::all_of(values.begin(), values.end(), [&](std::uint32_t v) { return v < limit; });
}

/// A range [first, first + count) within `size`, without overflow.
bool within(std::uint64_t first, std::uint64_t count, std::uint64_t size) {
  return count <= size && first <= size - count;
}

bool receiversAreSane(const light::Receivers& r) {
  const std::size_t slots = r.x.size();
  for (const auto* axis : {&r.x, &r.y, &r.z, &r.nx, &r.ny, &r.nz}) {
    if (axis->size() != slots || !sane(*axis)) return false;
  }
  if (r.point_of.size() != slots || r.groups.size() * light::Receivers::kGroup != slots)
    return false;
  if (!below(r.slot_of, slots) || !below(r.point_of, r.slot_of.size())) return false;
  std::uint32_t next = 0;
  for (const light::Receivers::Cluster& c : r.clusters) {
    // A place within a cluster is stored as a byte.
    if (c.begin != next || c.end <= c.begin || c.end > slots || c.end - c.begin > 256) return false;
    if (c.end % light::Receivers::kGroup != 0 || c.used == 0 || c.used > c.end - c.begin)
      return false;
    next = c.end;
  }
  return next == slots;
}

bool chartsAreSane(const Charts& charts) {
  if (charts.triangles.size() != charts.chart_of.size()) return false;
  if (!below(charts.chart_of, charts.charts.size())) return false;
  if (!below(charts.triangles, charts.chart_of.size())) return false;
  return std::all_of(charts.charts.begin(), charts.charts.end(), [&](const Chart& c) {
    const float numbers[] = {c.origin.x, c.origin.y, c.origin.z, c.t.x,   c.t.y,
                             c.t.z,      c.b.x,      c.b.y,      c.b.z,   c.normal.x,
                             c.normal.y, c.normal.z, c.size.x,   c.size.y};
    return c.sides <= kBothSides && sane(numbers) && std::isfinite(c.area) &&
           within(c.first_triangle, c.triangle_count, charts.triangles.size());
  });
}

bool gridsAreSane(const Texels& texels) {
  if (texels.grids.size() != texels.charts.charts.size()) return false;
  for (std::size_t i = 0; i < texels.grids.size(); ++i) {
    const Texels::Grid& grid = texels.grids[i];
    const std::uint8_t sides = texels.charts.charts[i].sides;
    if (grid.nu < 1 || grid.nv < 1 || !sane({&grid.cell.x, 2})) return false;
    if (!(grid.cell.x > 0.0F) || !(grid.cell.y > 0.0F)) return false;
    const auto per_side = static_cast<std::uint64_t>(grid.nu) * static_cast<std::uint64_t>(grid.nv);
    const std::uint64_t used = per_side * ((sides & 1U) + (sides >> 1U));
    if (!within(grid.first, used, texels.cells.size())) return false;
    if (grid.ku < 1 || grid.kv < 1 || grid.ku > 4 || grid.kv > 4 || grid.nu % grid.ku != 0 || grid.nv % grid.kv != 0) return false;
    const std::uint64_t bases = used / (static_cast<std::uint64_t>(grid.ku) * static_cast<std::uint64_t>(grid.kv));
    if (!within(grid.first_base, bases, texels.split.size())) return false;
  }
  if (!texels.links.empty() && texels.links.size() != texels.cells.size()) return false;
  return std::all_of(texels.cells.begin(), texels.cells.end(), [&](std::uint32_t slot) {
    return slot == kNoTexel || slot < texels.slotCount();
  });
}

bool texelsAreSane(const Texels& texels) {
  const std::size_t slots = texels.receivers.slotCount();
  return texels.area.size() == slots && texels.material.size() == slots &&
         texels.triangle.size() == slots && texels.uv.size() == slots &&
         texels.uv_width.size() == slots && texels.openness.size() == slots && texels.part.size() == slots && sane(texels.area) && saneVectors(texels.uv) &&
         sane(texels.uv_width) && below(texels.triangle, texels.charts.chart_of.size()) &&
         std::isfinite(texels.cell);
}

/// Patches follow each other without gaps, each within one cluster and of whole groups; so do their
/// functions.
bool patchesAreSane(const Nodes& nodes, const light::Receivers& receivers) {
  std::uint64_t function = 0;
  std::uint64_t slot = 0;
  std::size_t cluster = 0;
  for (const Nodes::Patch& p : nodes.patches) {
    if (cluster == receivers.clusters.size() || p.begin != slot || p.end <= p.begin) return false;
    if (p.end > receivers.clusters[cluster].end || p.end % light::Receivers::kGroup != 0)
      return false;
    if (!std::isfinite(p.area) || p.first != function || p.count < 1 || p.count > 3) return false;
    function += p.count;
    slot = p.end;
    if (slot == receivers.clusters[cluster].end) ++cluster;
  }
  return slot == receivers.slotCount() && nodes.functions == function &&
         nodes.stride == (nodes.functions + 15) / 16 * 16;
}

bool matrixIsSane(const NodeMatrix& matrix, std::size_t patches) {
  if (patches == 0) return matrix.first.size() <= 1 && matrix.blocks.empty();
  if (matrix.first.size() != patches + 1 || matrix.first.front() != 0) return false;
  if (!std::is_sorted(matrix.first.begin(), matrix.first.end())) return false;
  if (matrix.first.back() != matrix.blocks.size()) return false;
  return std::all_of(matrix.blocks.begin(), matrix.blocks.end(), [&](const auto& block) {
    return block.sender < patches && sane(block.value);
  });
}

bool nodesAreSane(const Nodes& nodes, const light::Receivers& receivers) {
  const std::size_t slots = receivers.slotCount();
  if (nodes.patch_of.size() != slots || nodes.phi.size() != slots) return false;
  if (!below(nodes.patch_of, nodes.patches.size()) || !saneVectors(nodes.phi)) return false;
  return patchesAreSane(nodes, receivers) && matrixIsSane(nodes.matrix, nodes.patches.size());
}

bool gatherListsAreSane(const GatherLists& lists, std::size_t slots) {
  if (!std::all_of(lists.entries.begin(), lists.entries.end(),
                   [&](GatherLists::Entry e) { return (e >> 4U) < slots; })) {
    return false;
  }
  // Lists follow each other without gaps, as append() makes them.
  std::uint64_t next = 0;
  for (const GatherLists::List& list : lists.lists) {
    const std::uint64_t grouped = std::uint64_t{list.groups} * GatherLists::kGroup;
    if (list.first != next || list.rest >= GatherLists::kGroup || !sane({&list.scale, 1}) ||
        !within(next, grouped + list.rest, lists.entries.size())) {
      return false;
    }
    // Only the first of a group has a code; the others are offsets as they stand.
    for (std::uint64_t k = 0; k < grouped + list.rest; ++k) {
      const bool leads = k < grouped && k % GatherLists::kGroup == 0;
      if (!leads && (lists.entries[next + k] & 15U) != 0) return false;
    }
    next += grouped + list.rest;
  }
  return next == lists.entries.size();
}

bool nodeListsAreSane(const NodeLists& lists, const Operators& operators) {
  const std::size_t patches = operators.nodes.patches.size();
  if (operators.coarse && lists.lists.empty()) return lists.entries.empty();
  if (lists.lists.size() != operators.lists.lists.size()) return false;
  if (lists.constants.lists.size() != lists.lists.size()) return false;
  if (!gatherListsAreSane(lists.constants, patches)) return false;
  return std::all_of(lists.lists.begin(), lists.lists.end(), [&](const NodeLists::List& list) {
    if (!within(list.first, list.count, lists.entries.size()) || !sane({&list.scale, 1}))
      return false;
    std::uint64_t patch = 0;
    for (std::uint32_t e = list.first; e < list.first + list.count; ++e) {
      patch += lists.entries[e].gap;
    }
    return list.count == 0 || patch < patches;
  });
}

bool weightsAreSane(const Operators& operators) {
  const auto& clusters = operators.texels.receivers.clusters;
  if (!sane(operators.list_area)) return false;
  if (!std::all_of(operators.weights.begin(), operators.weights.end(), std::mem_fn(&Half::finite)))
    return false;
  if (operators.list_area.size() != operators.lists.lists.size()) return false;
  if (operators.coarse && operators.clusters.empty()) return true;
  if (operators.clusters.size() != clusters.size()) return false;
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const ClusterWeights& w = operators.clusters[i];
    const std::uint64_t count = std::uint64_t{w.rank} * (clusters[i].end - clusters[i].begin);
    if (w.rank > 256 || !within(w.first_list, w.rank, operators.lists.lists.size())) return false;
    if (!within(w.first_weight, count, operators.weights.size())) return false;
  }
  return true;
}

}  // namespace

std::string inconsistency(const Operators& operators) {
  const std::size_t slots = operators.texels.receivers.slotCount();
  if (!receiversAreSane(operators.texels.receivers)) return "receivers";
  if (!chartsAreSane(operators.texels.charts)) return "charts";
  if (!texelsAreSane(operators.texels)) return "texels";
  if (!gridsAreSane(operators.texels)) return "grids";
  if (operators.area.size() != slots || operators.sends.size() != slots ||
      operators.fill_from.size() != slots || operators.buried.size() != slots || !sane(operators.area) || !sane(operators.sends) ||
      !below(operators.fill_from, slots)) {
    return "texel areas";
  }
  if (!nodesAreSane(operators.nodes, operators.texels.receivers)) return "nodes";
  if (!gatherListsAreSane(operators.lists, FarBlocks::sizeFor(slots))) return "gather lists";
  if (!nodeListsAreSane(operators.node_lists, operators)) return "node lists";
  if (!weightsAreSane(operators)) return "weights";
  return {};
}

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/operators.h"

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

/// Operators as a list of arrays of plain records, the form in which they are stored.
namespace soffit::transfer {

/// A chart without padding bytes, so that equal charts are equal bytes.
struct ChartRecord {
  std::uint8_t planar = 0;
  std::uint8_t sides = 0;
  std::uint16_t zero = 0;
  std::uint32_t material = 0;
  vec3 origin, t, b, normal;
  vec2 size;
  double area = 0.0;
  std::uint32_t first_triangle = 0;
  std::uint32_t triangle_count = 0;
};

/// The members that are single values.
struct ScalarRecord {
  double cell = 0.0;
  std::uint64_t functions = 0;
  std::uint64_t stride = 0;
  std::uint64_t coarse = 0;
  double conserve = 1.0;
};

/// What is stored in another form than in memory.
struct Records {
  std::vector<ChartRecord> charts;
  std::vector<ScalarRecord> scalars;
};

Records recordsOf(const Operators& operators);

/// The way back. Returns what is wrong with the records, empty when nothing is.
std::string applyRecords(const Records& records, Operators& operators);

/// Calls visit(name, array) for every array, always in the same order. Charts and single values
/// come from `records`. Ops is Operators or const Operators, Recs alike.
///
/// The structures are taken apart, so that a member that is added to one of them does not compile
/// until it is stored too (raise kBakeVersion then).
template <class Ops, class Recs, class Visit>
void forEachArray(Ops& operators, Recs& records, Visit&& visit) {
  auto& [texels, area, fill_from, buried, sends, nodes, lists, node_lists, clusters, weights, list_area,
         conserve, coarse] = operators;
  auto& [receivers, texel_area, material, triangle, openness, part, uv, uv_width, charts, cell, grids, cells, split,
         links] =
      texels;
  auto& [x, y, z, nx, ny, nz, slot_of, point_of, receiver_clusters, groups] = receivers;
  auto& [chart_list, chart_triangles, chart_of] = charts;
  auto& [patches, patch_of, phi, functions, stride, matrix] = nodes;
  auto& [matrix_first, matrix_blocks] = matrix;
  auto& [list_entries, list_list] = lists;
  auto& [node_constants, node_entries, node_list] = node_lists;
  auto& [constant_entries, constant_list] = node_constants;
  visit("scalars", records.scalars);  // cell, functions, stride, coarse, conserve
  static_cast<void>(cell), static_cast<void>(functions), static_cast<void>(stride),
      static_cast<void>(coarse), static_cast<void>(conserve);
  visit("charts", records.charts);
  static_cast<void>(chart_list);
  visit("charts.triangles", chart_triangles);
  visit("charts.chart_of", chart_of);
  visit("receivers.x", x);
  visit("receivers.y", y);
  visit("receivers.z", z);
  visit("receivers.nx", nx);
  visit("receivers.ny", ny);
  visit("receivers.nz", nz);
  visit("receivers.slot_of", slot_of);
  visit("receivers.point_of", point_of);
  visit("receivers.clusters", receiver_clusters);
  visit("receivers.groups", groups);
  visit("texels.area", texel_area);
  visit("texels.material", material);
  visit("texels.triangle", triangle);
  visit("texels.openness", openness);
  visit("texels.part", part);
  visit("texels.uv", uv);
  visit("texels.uv_width", uv_width);
  visit("texels.grids", grids);
  visit("texels.cells", cells);
  visit("texels.split", split);
  visit("texels.links", links);
  visit("area", area);
  visit("fill_from", fill_from);
  visit("buried", buried);
  visit("sends", sends);
  visit("nodes.patches", patches);
  visit("nodes.patch_of", patch_of);
  visit("nodes.phi", phi);
  visit("nodes.matrix_first", matrix_first);
  visit("nodes.matrix_blocks", matrix_blocks);
  visit("lists.entries", list_entries);
  visit("lists.lists", list_list);
  visit("node_lists.constants.entries", constant_entries);
  visit("node_lists.constants.lists", constant_list);
  visit("node_lists.entries", node_entries);
  visit("node_lists.lists", node_list);
  visit("clusters", clusters);
  visit("weights", weights);
  visit("list_area", list_area);
}

// Records are stored as they lie in memory: plain, and without bytes that mean nothing.
template <class Record, std::size_t size_of_members>
inline constexpr bool is_packed = std::is_trivially_copyable_v<Record> &&
                                  sizeof(Record) == size_of_members;
static_assert(is_packed<ChartRecord, 2 * 1 + 2 + 4 + 4 * 12 + 8 + 8 + 2 * 4>);
static_assert(is_packed<ScalarRecord, 5 * 8>);
static_assert(is_packed<vec2, 2 * 4> && is_packed<vec3, 3 * 4>);
static_assert(is_packed<light::Receivers::Bounds, 3 * 12 + 4>);
static_assert(is_packed<light::Receivers::Cluster, 3 * 4 + sizeof(light::Receivers::Bounds)>);
static_assert(is_packed<Texels::Grid, 6 * 4 + 8>);
static_assert(is_packed<Nodes::Patch, 4 * 4 + 8>);
static_assert(is_packed<NodeMatrix::Block, 4 + 9 * 4>);
static_assert(is_packed<GatherLists::Entry, 4>);
static_assert(is_packed<GatherLists::List, 8 + 4 * 4>);
static_assert(is_packed<NodeLists::Entry, 2 + 2>);
static_assert(is_packed<NodeLists::List, 3 * 4>);
static_assert(is_packed<Half, 2>);
static_assert(is_packed<ClusterWeights, 2 * 4 + 8>);

}  // namespace soffit::transfer

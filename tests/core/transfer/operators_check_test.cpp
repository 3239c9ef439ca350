// SPDX-License-Identifier: MIT
#include "core/transfer/operators_check.h"

#include "core/transfer/far_blocks.h"

#include "core/transfer/kernels.h"
#include "core/transfer/node_kernels.h"
#include "core/transfer/node_solver.h"
#include "core/transfer/operator_arrays.h"
#include "tests/core/transfer/small_bake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace soffit::transfer {
namespace {

using testing::smallBake;

TEST(Inconsistency, NoneInABake) {
  EXPECT_EQ(inconsistency(smallBake()), "");
  Operators free_space;
  free_space.coarse = true;
  EXPECT_EQ(inconsistency(free_space), "");
}

template <class Change>
std::string after(const Change& change) {
  Operators operators = smallBake();
  change(operators);
  return inconsistency(operators);
}

TEST(Inconsistency, NamesThePart) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(after([](Operators& o) { o.texels.receivers.clusters.back().end += 16; }), "receivers");
  EXPECT_EQ(after([](Operators& o) { o.texels.receivers.point_of[0] = 1U << 20U; }), "receivers");
  EXPECT_EQ(after([](Operators& o) { o.texels.charts.chart_of[0] = 1000; }), "charts");
  EXPECT_EQ(after([](Operators& o) { o.texels.charts.charts[0].sides = 4; }), "charts");
  EXPECT_EQ(after([](Operators& o) { o.texels.triangle[0] = 1000; }), "texels");
  EXPECT_EQ(after([&](Operators& o) { o.texels.uv[0].y = nan; }), "texels");
  EXPECT_EQ(after([](Operators& o) { o.texels.grids[0].nu = 1 << 30; }), "grids");
  EXPECT_EQ(after([](Operators& o) { o.texels.cells[0] = 1U << 20U; }), "grids");
  EXPECT_EQ(after([](Operators& o) { o.fill_from.back() = 1U << 20U; }), "texel areas");
  EXPECT_EQ(after([&](Operators& o) { o.sends[0] = nan; }), "texel areas");
  EXPECT_EQ(after([](Operators& o) { o.nodes.patch_of[0] = 1000; }), "nodes");
  EXPECT_EQ(after([](Operators& o) { o.nodes.stride += 16; }), "nodes");
  EXPECT_EQ(after([](Operators& o) { o.nodes.patches[0].end += 16; }), "nodes");
  EXPECT_EQ(after([](Operators& o) { o.nodes.patches.pop_back(); }), "nodes");
  EXPECT_EQ(after([](Operators& o) { o.nodes.matrix.first[1] = 1U << 30U; }), "nodes");
  EXPECT_EQ(after([](Operators& o) { o.nodes.matrix.first.pop_back(); }), "nodes");
  EXPECT_EQ(after([](Operators& o) { o.nodes.matrix.blocks[3].sender = 5000; }), "nodes");
  EXPECT_EQ(after([&](Operators& o) { o.nodes.matrix.blocks[3].value[8] = nan; }), "nodes");
  EXPECT_EQ(after([](Operators& o) { o.lists.entries.pop_back(); }), "gather lists");
  EXPECT_EQ(after([](Operators& o) { o.lists.entries.back() = 0xfffffff0U; }), "gather lists");
  EXPECT_EQ(after([](Operators& o) { o.lists.lists.back().groups += 1; }), "gather lists");
  EXPECT_EQ(after([](Operators& o) { o.lists.lists.back().rest = 4; }), "gather lists");
  EXPECT_EQ(after([](Operators& o) { o.lists.lists.back().first += 1; }), "gather lists");
  // A code where an offset is read as it stands.
  EXPECT_EQ(after([](Operators& o) { o.lists.entries[o.lists.lists[0].first + 1] |= 1U; }), "gather lists");
  EXPECT_EQ(after([](Operators& o) { o.node_lists.constants.entries[0] = 0xfffffff0U; }), "node lists");
  EXPECT_EQ(after([](Operators& o) { o.node_lists.constants.lists.pop_back(); }), "node lists");
  EXPECT_EQ(after([](Operators& o) {
              const NodeLists::List& list = o.node_lists.lists[0];
              for (std::uint32_t k = 0; k < list.count; ++k) o.node_lists.entries[k].gap = 65535;
            }),
            "node lists");
  EXPECT_EQ(after([](Operators& o) { o.node_lists.lists[0].first = 1U << 31U; }), "node lists");
  EXPECT_EQ(after([](Operators& o) { o.node_lists.lists.pop_back(); }), "node lists");
  EXPECT_EQ(after([](Operators& o) { o.clusters.back().first_weight += 1; }), "weights");
  EXPECT_EQ(after([&](Operators& o) { o.weights[0] = std::numeric_limits<float>::infinity(); }),
            "weights");
}

/// Everything that follows an index of the operators, as relight does.
float use(const Operators& o, std::size_t triangles) {
  const std::size_t slots = o.texels.slotCount();
  float sum = 0.0F;
  std::array<std::uint32_t, Texels::kMostAround> near{};
  std::array<float, Texels::kMostAround> share{};
  for (std::uint32_t t = 0; t < triangles; ++t) {
    for (const bool front : {false, true}) {
      const int count = o.texels.around(t, front, vec3(1.0F, 0.5F, 0.25F), near, share);
      for (int i = 0; i < count; ++i) sum += o.area[near[static_cast<std::size_t>(i)]];
    }
  }
  const std::vector<vec4> x(FarBlocks::sizeFor(slots), vec4(1.0F));
  const std::vector<PatchLight> b(o.nodes.patches.size());
  const std::vector<vec4> constants(b.size());
  std::vector<vec4> y(o.lists.lists.size());
  gather(o.lists, 0, x, y);
  if (!o.coarse) gatherNodes(o.node_lists, 0, b, constants, y);
  std::vector<float> plane(slots, 0.0F);
  for (std::size_t i = 0; i < o.clusters.size(); ++i) {
    const light::Receivers::Cluster& c = o.texels.receivers.clusters[i];
    const std::size_t count = c.end - c.begin;
    interpolate(
        std::span(o.weights).subspan(o.clusters[i].first_weight, o.clusters[i].rank * count),
        std::span(y).subspan(o.clusters[i].first_list, o.clusters[i].rank), count, &plane[c.begin],
        &plane[c.begin], &plane[c.begin]);
  }
  for (std::size_t k = 0; k < y.size(); ++k) sum += o.list_area[k];
  for (std::size_t s = 0; s < slots; ++s) {
    sum += plane[o.fill_from[s]] + o.sends[s] +
           o.texels.receivers.x[o.texels.receivers.slot_of[o.texels.receivers.point_of[s]]] +
           static_cast<float>(o.nodes.patches[o.nodes.patch_of[s]].first);
  }
  NodeSolver::Vectors coefficients(1, std::vector<float>(o.nodes.stride, 0.0F));
  NodeSolver::Vectors indirect;
  restrictToNodes(o.nodes, o.area, plane, coefficients[0]);
  for (const Nodes::Patch& p : o.nodes.patches) {
    const float* e = &plane[p.begin];
    sum += restrictSent(o.nodes, p, o.area, {plane, plane, plane}, {e, e, e}).c[0].x;
  }
  const std::vector<float> grey(slots, 0.5F);
  const std::span<const float> channel(grey);
  NodeSolver(o.nodes, o.area, std::span(&channel, 1)).solve(coefficients, indirect);
  prolongFromNodes(o.nodes, indirect[0], plane);
  return sum + (plane.empty() ? 0.0F : plane[0]);
}

/// Changes one array: a byte, a whole number, or its length.
class Mutation {
 public:
  Mutation(std::mt19937& random, std::size_t arrays) : random_(random), skip_(random() % arrays) {}

  template <class T>
  void operator()(std::string_view, std::vector<T>& array) {
    if (skip_-- != 0 || array.empty()) return;
    const std::uint32_t kind = random_() % 8;
    if (kind == 0) {
      array.resize(random_() % (2 * array.size()));
    } else if (kind == 1) {
      array.pop_back();
    } else {
      auto bytes = std::as_writable_bytes(std::span(array));
      const std::size_t at = random_() % bytes.size();
      constexpr std::array<std::uint8_t, 4> kNotable = {0x00, 0xff, 0x7f, 0x80};
      const std::size_t length = kind < 5 ? 1 : std::min<std::size_t>(4, bytes.size() - at / 4 * 4);
      const std::uint8_t value =
          kind % 2 == 0 ? kNotable[random_() % 4] : static_cast<std::uint8_t>(random_());
      for (std::size_t i = 0; i < length; ++i)
        bytes[(length == 1 ? at : at / 4 * 4) + i] = std::byte{value};
    }
  }

 private:
  std::mt19937& random_;
  std::size_t skip_;
};

// What passes the check can be used: run under the address sanitizer this is a proof for the
// mutations that were drawn. Numbers may be wrong; memory is not touched where it should not be.
TEST(Inconsistency, WhatPassesCanBeUsed) {
  const std::size_t triangles = testing::roomMesh().triangles.size();
  std::mt19937 random(7);
  std::size_t arrays = 0;
  Records none;
  Operators counted;
  forEachArray(counted, none, [&](std::string_view, const auto&) { ++arrays; });
  int refused = 0;
  int used = 0;
  for (int i = 0; i < 3000; ++i) {
    Operators operators = smallBake();
    Records records = recordsOf(operators);
    forEachArray(operators, records, Mutation(random, arrays));
    std::string trouble = applyRecords(records, operators);
    if (trouble.empty()) trouble = inconsistency(operators);
    // The number of mesh triangles is the caller's to compare (bakeOrLoad does).
    if (!trouble.empty() || operators.texels.charts.chart_of.size() != triangles) {
      ++refused;
      continue;
    }
    static_cast<void>(use(operators, triangles));
    ++used;
  }
  EXPECT_GT(refused, 500);
  EXPECT_GT(used, 500);
}

}  // namespace
}  // namespace soffit::transfer

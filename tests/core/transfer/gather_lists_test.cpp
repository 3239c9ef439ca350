// SPDX-License-Identifier: MIT
// Gather lists through what they do: sums of light over the rays that were given.
#include "core/transfer/gather_lists.h"

#include "core/math/rng.h"
#include "core/transfer/kernels.h"
#include "core/transfer/node_kernels.h"
#include "core/transfer/node_solver.h"
#include "tests/core/transfer/every_target.h"
#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace soffit::transfer {
namespace {

using namespace testing;

std::vector<vec4> constantsOf(std::span<const PatchLight> b) {
  std::vector<vec4> out;
  for (const PatchLight& p : b) out.push_back(p.c[0]);
  return out;
}

struct Lists {
  Texels texels;
  std::vector<std::vector<std::uint32_t>> rays;  ///< per list, as given
  GatherLists lists;
};

/// Lists of `count` rays to random texels, a tenth of them dark.
Lists randomLists(std::size_t lists, std::size_t count, std::uint64_t seed) {
  Lists out;
  const auto scene = sceneOf(blockRoom());
  out.texels = makeTexels(*scene->mesh, scene->sides, 0.15, nullptr);
  Rng rng(seed);
  for (std::size_t k = 0; k < lists; ++k) {
    std::vector<std::uint32_t> slots;
    // Most rays near each other, as real ones are: texels are met several times.
    const auto middle = rng.uniform();
    for (std::size_t r = 0; r < count; ++r) {
      const float place = r % 2 == 0
                              ? rng.uniform()
                              : std::clamp(middle + 0.01F * (rng.uniform() - 0.5F), 0.0F, 0.999F);
      const auto point =
          static_cast<std::size_t>(place * static_cast<float>(out.texels.texelCount()));
      slots.push_back(
          r % 10 == 3 ? kNoTexel
                      : out.texels.receivers.slot_of[std::min(point, out.texels.texelCount() - 1)]);
    }
    out.rays.push_back(slots);
    out.lists.append(slots);
  }
  return out;
}

std::vector<vec4> randomLight(std::size_t n, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<vec4> x(n);
  for (vec4& v : x) v = {rng.uniform(), 2 * rng.uniform(), 3 * rng.uniform(), 0};
  return x;
}

dvec3 expected(std::span<const std::uint32_t> rays, std::span<const vec4> x) {
  dvec3 sum(0.0);
  for (const std::uint32_t s : rays) {
    if (s != kNoTexel) sum += dvec3(x[s]);
  }
  return sum / static_cast<double>(rays.size());
}

void expectNear(const vec4& found, const dvec3& wanted, double tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(static_cast<double>(found[c]), wanted[c], tolerance);
}

// Round-off: sums of up to 4096 single precision numbers of about 1.
constexpr double kRoundoff = 1e-5;

TEST(GatherLists, GiveTheMeanOverTheirRays) {
  for (const std::size_t rays : {1U, 7U, 64U, 1024U, 4096U}) {
    const Lists l = randomLists(5, rays, 3);
    ASSERT_EQ(l.lists.lists.size(), 5U);
    const std::vector<vec4> x = randomLight(l.texels.slotCount(), 4);
    std::vector<vec4> y(5);
    gather(l.lists, 0, x, y);
    for (std::size_t k = 0; k < 5; ++k) expectNear(y[k], expected(l.rays[k], x), kRoundoff);
  }
}

TEST(GatherLists, ATexelThatManyRaysMeetCountsThemAll) {
  const Lists l = randomLists(0, 0, 1);
  GatherLists lists;
  std::vector<std::uint32_t> slots(4096, 5);  // more than a byte holds
  lists.append(slots);
  const std::vector<vec4> x = randomLight(l.texels.slotCount(), 4);
  std::vector<vec4> y(1);
  gather(lists, 0, x, y);
  expectNear(y[0], dvec3(x[5]), kRoundoff);
}

TEST(GatherLists, NoRaysOrDarkOnesGiveNothing) {
  const Lists l = randomLists(0, 0, 1);
  GatherLists lists;
  std::vector<std::uint32_t> dark(64, kNoTexel);
  lists.append(dark);
  const std::vector<vec4> x = randomLight(l.texels.slotCount(), 4);
  std::vector<vec4> y(1, vec4(7.0F));
  gather(lists, 0, x, y);
  EXPECT_EQ(y[0], vec4(0.0F));
}

TEST(GatherLists, AppendedSetsStayWhatTheyWere) {
  const Lists a = randomLists(3, 200, 5);
  const Lists b = randomLists(4, 300, 6);
  GatherLists both;
  both.append(a.lists);
  both.append(b.lists);
  EXPECT_EQ(both.lists.size(), 7U);
  EXPECT_EQ(both.bytes(), a.lists.bytes() + b.lists.bytes());
  const std::vector<vec4> x = randomLight(a.texels.slotCount(), 4);
  std::vector<vec4> y(7);
  std::vector<vec4> ya(3);
  std::vector<vec4> yb(4);
  gather(both, 0, x, y);
  gather(a.lists, 0, x, ya);
  gather(b.lists, 0, x, yb);
  ya.insert(ya.end(), yb.begin(), yb.end());
  EXPECT_EQ(y, ya);
  // From the middle on.
  std::vector<vec4> part(2);
  gather(both, 4, x, part);
  EXPECT_EQ(part[0], y[4]);
  EXPECT_EQ(part[1], y[5]);
}

/// Lists of `rays` rays to so many slots, without texels behind them.
GatherLists listsOver(std::size_t lists, std::size_t rays, std::uint32_t count,
                      std::vector<std::vector<std::uint32_t>>& given) {
  Rng rng(8);
  GatherLists out;
  for (std::size_t k = 0; k < lists; ++k) {
    std::vector<std::uint32_t>& slots = given.emplace_back();
    while (slots.size() < rays) {
      const auto slot =
          static_cast<std::uint32_t>(rng.uniform() * 0.9999F * static_cast<float>(count));
      // From one ray to several times what an entry holds.
      const std::size_t times = std::min<std::size_t>(rays - slots.size(), 1 + (slot * slot) % 700);
      slots.insert(slots.end(), slot % 3 == 0 ? times : 1, slot);
    }
    std::vector<std::uint32_t> copy = slots;
    out.append(copy);
  }
  return out;
}

TEST(GatherLists, EveryRayIsKeptOverAnyNumberOfSlots) {
  for (const std::uint32_t count : {100U, 8192U, 163840U}) {
    std::vector<std::vector<std::uint32_t>> given;
    const GatherLists lists = listsOver(3, 4096, count, given);
    const std::vector<vec4> x = randomLight(count, 4);
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<std::uint32_t> found;
      lists.forEachEntry(lists.lists[k], [&](std::uint32_t slot, std::uint32_t rays) {
        found.insert(found.end(), rays, slot);
      });
      std::sort(found.begin(), found.end());
      std::sort(given[k].begin(), given[k].end());
      EXPECT_EQ(found, given[k]);
    }
    forEveryTarget([&] {
      std::vector<vec4> y(3);
      gather(lists, 0, x, y);
      for (std::size_t k = 0; k < 3; ++k) expectNear(y[k], expected(given[k], x), kRoundoff);
    });
  }
}

TEST(NodeLists, GatherSmoothLightLikeTheTexelsDo) {
  const Lists l = randomLists(8, 1024, 10);
  const Nodes nodes = makeNodes(l.texels, l.texels.area, 64);
  const NodeLists lists = makeNodeLists(l.lists, nodes);
  ASSERT_EQ(lists.lists.size(), 8U);
  std::vector<vec4> x(l.texels.slotCount());
  NodeSolver::Vectors coefficients(3);
  for (std::size_t c = 0; c < 3; ++c) {
    coefficients[c].assign(nodes.stride, 0.0F);
    for (std::size_t f = 0; f < nodes.functions; ++f) {
      coefficients[c][f] = 1.0F + 0.2F * std::sin(static_cast<float>(f * (c + 1)));
    }
    std::vector<float> value(x.size());
    prolongFromNodes(nodes, coefficients[c], value);
    for (std::size_t s = 0; s < x.size(); ++s) x[s][static_cast<int>(c)] = value[s];
  }
  std::vector<vec4> y(8, vec4(1.0F));
  const std::vector<PatchLight> b = toPatches(nodes, coefficients);
  gatherNodes(lists, 0, b, constantsOf(b), y);
  for (std::size_t k = 0; k < 8; ++k) {
    // Sums of phi within 1.5 deviations of 0 are left out: at most 1.5 sqrt(8) rays per patch and
    // function, times coefficients of 1, over some 130 patches with random signs.
    expectNear(y[k], expected(l.rays[k], x), 11.4 * 2 * 0.5 * 1.5 * 2.8 / 1024);
  }
}

TEST(NodeLists, SumsAndGapsThatNoEntryHoldsTakeSeveral) {
  // 70,000 patches of 4 slots; rays to the first, to far ones, and 5000 to one: all too far from 0
  // for chance.
  constexpr std::uint32_t kPatches = 70000;
  Nodes nodes;
  for (std::uint32_t i = 0; i < kPatches; ++i) {
    for (std::uint32_t s = 0; s < 4; ++s) {
      nodes.patch_of.push_back(i);
      nodes.phi.emplace_back(s < 2 ? -2.0F : 2.0F, s % 2 == 0 ? -2.5F : 2.5F);
    }
  }
  std::vector<std::uint32_t> slots = {0, 0, 0, 600 * 4, 699 * 4 + 3, (kPatches - 1) * 4 + 2};
  slots.insert(slots.end(), 5000, 700 * 4 + 1);
  slots.push_back(kNoTexel);
  const std::vector<std::uint32_t> rays = slots;
  GatherLists lists;
  lists.append(slots);
  const NodeLists node_lists = makeNodeLists(lists, nodes);
  Rng rng(3);
  std::vector<PatchLight> b(kPatches);
  std::vector<vec4> x(nodes.phi.size());
  for (PatchLight& p : b) {
    for (vec4& c : p.c) c = {rng.uniform(), rng.uniform(), rng.uniform(), 0.0F};
  }
  for (std::size_t s = 0; s < x.size(); ++s) {
    const PatchLight& p = b[nodes.patch_of[s]];
    x[s] = p.c[0] + nodes.phi[s].x * p.c[1] + nodes.phi[s].y * p.c[2];
  }
  forEveryTarget([&] {
    std::vector<vec4> y(1);
    gatherNodes(node_lists, 0, b, constantsOf(b), y);
    // Here all sums of phi are whole steps of half a ray: only rounding is left.
    expectNear(y[0], expected(rays, x), 10 * kRoundoff);
  });
}

TEST(NodeLists, WhatChanceExplainsIsLeftOut) {
  Nodes nodes;
  nodes.patch_of.assign(16, 0);
  for (std::uint32_t s = 0; s < 16; ++s) nodes.phi.emplace_back(s < 8 ? -1.0F : 1.0F, 0.0F);
  GatherLists lists;
  std::vector<std::uint32_t> even = {0, 1, 2, 9, 10};      // sum -1, deviation 2.2
  std::vector<std::uint32_t> one_sided = {0, 1, 2, 3, 4};  // sum -5
  lists.append(even);
  lists.append(one_sided);
  const NodeLists node_lists = makeNodeLists(lists, nodes);
  EXPECT_EQ(node_lists.lists[0].count, 0U);
  EXPECT_EQ(node_lists.lists[1].count, 1U);
}

}  // namespace
}  // namespace soffit::transfer

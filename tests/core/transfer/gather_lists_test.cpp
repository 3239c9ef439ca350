// SPDX-License-Identifier: MIT
// Gather lists through what they do: sums of light over the rays that were given.
#include "core/transfer/gather_lists.h"

#include "core/math/rng.h"
#include "core/transfer/kernels.h"
#include "core/transfer/node_kernels.h"
#include "core/transfer/node_solver.h"
#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::transfer {
namespace {

using namespace testing;

struct Lists {
  Texels texels;
  SlotClusters clusters;
  std::vector<std::vector<std::uint32_t>> rays;  ///< per list, as given
  GatherLists lists;
};

/// Lists of `count` rays to random texels, a tenth of them dark.
Lists randomLists(std::size_t lists, std::size_t count, std::uint64_t seed) {
  Lists out;
  const auto scene = sceneOf(blockRoom());
  out.texels = makeTexels(*scene->mesh, scene->sides, 0.15, nullptr);
  out.clusters = slotClusters(out.texels.receivers);
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
    out.lists.append(slots, out.clusters);
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
    gather(l.lists, 0, x, {}, y);
    for (std::size_t k = 0; k < 5; ++k) expectNear(y[k], expected(l.rays[k], x), kRoundoff);
  }
}

TEST(GatherLists, ATexelThatManyRaysMeetCountsThemAll) {
  const Lists l = randomLists(0, 0, 1);
  GatherLists lists;
  std::vector<std::uint32_t> slots(4096, 5);  // more than a byte holds
  lists.append(slots, l.clusters);
  const std::vector<vec4> x = randomLight(l.texels.slotCount(), 4);
  std::vector<vec4> y(1);
  gather(lists, 0, x, {}, y);
  expectNear(y[0], dvec3(x[5]), kRoundoff);
}

TEST(GatherLists, NoRaysOrDarkOnesGiveNothing) {
  const Lists l = randomLists(0, 0, 1);
  GatherLists lists;
  std::vector<std::uint32_t> dark(64, kNoTexel);
  lists.append(dark, l.clusters);
  const std::vector<vec4> x = randomLight(l.texels.slotCount(), 4);
  std::vector<vec4> y(1, vec4(7.0F));
  gather(lists, 0, x, {}, y);
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
  gather(both, 0, x, {}, y);
  gather(a.lists, 0, x, {}, ya);
  gather(b.lists, 0, x, {}, yb);
  ya.insert(ya.end(), yb.begin(), yb.end());
  EXPECT_EQ(y, ya);
  // From the middle on.
  std::vector<vec4> part(2);
  gather(both, 4, x, {}, part);
  EXPECT_EQ(part[0], y[4]);
  EXPECT_EQ(part[1], y[5]);
}

TEST(GatherLists, DarkClustersAreSkipped) {
  const Lists l = randomLists(6, 500, 8);
  std::vector<vec4> x = randomLight(l.texels.slotCount(), 4);
  std::vector<std::uint8_t> lit(l.texels.receivers.clusters.size());
  for (std::size_t c = 0; c < lit.size(); ++c) {
    lit[c] = c % 3 == 0 ? 1 : 0;
    const light::Receivers::Cluster& cluster = l.texels.receivers.clusters[c];
    if (lit[c] == 0) std::fill(x.begin() + cluster.begin, x.begin() + cluster.end, vec4(0.0F));
  }
  std::vector<vec4> y(6);
  gather(l.lists, 0, x, lit, y);
  for (std::size_t k = 0; k < 6; ++k) expectNear(y[k], expected(l.rays[k], x), kRoundoff);
}

TEST(GatherTinted, IsTheGatherOfReflectedWhiteLight) {
  // Few reflectances a cluster (a palette), and more than it holds (textures).
  for (const std::size_t paints : {3U, 40U}) {
    const Lists l = randomLists(6, 500, 9);
    const std::size_t slots = l.texels.slotCount();
    Rng rng(2);
    std::vector<float> lux(slots);
    std::array<std::vector<float>, 3> rho;
    for (auto& channel : rho) channel.resize(slots);
    std::vector<std::size_t> paint(slots);
    for (std::size_t s = 0; s < slots; ++s) {
      lux[s] = 100.0F * rng.uniform();
      paint[s] = static_cast<std::size_t>(rng.uniform() * 0.999F * static_cast<float>(paints));
      for (std::size_t c = 0; c < 3; ++c) {
        rho[c][s] = static_cast<float>(1 + paint[s] + 2 * c) / static_cast<float>(2 * paints + 10);
      }
    }
    std::vector<Palette> palettes(l.texels.receivers.clusters.size());
    std::vector<float> packed = lux;
    for (std::size_t k = 0; k < palettes.size() && paints <= Palette::kMost; ++k) {
      palettes[k].size = static_cast<std::uint32_t>(paints);
      const light::Receivers::Cluster& cluster = l.texels.receivers.clusters[k];
      for (std::uint32_t s = cluster.begin; s < cluster.end; ++s) {
        for (std::size_t c = 0; c < 3; ++c) palettes[k].rho[c][paint[s]] = rho[c][s];
        packed[s] = TintedLight::pack(lux[s], static_cast<std::uint32_t>(paint[s]));
      }
    }
    const std::vector<std::uint8_t> lit(palettes.size(), 1);
    std::vector<vec4> y(6);
    gatherTinted(l.lists, 0,
                 {.lux = packed, .rho = {rho[0], rho[1], rho[2]}, .palettes = palettes, .lit = lit},
                 y);
    std::vector<vec4> x(slots);
    for (std::size_t s = 0; s < slots; ++s)
      x[s] = {rho[0][s] * lux[s], rho[1][s] * lux[s], rho[2][s] * lux[s], 0};
    for (std::size_t k = 0; k < 6; ++k) {
      expectNear(y[k], expected(l.rays[k], x),
                 2e-6 * 100 + 100 * kRoundoff);  // packing, and sums of up to 100
    }
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
  gatherNodes(lists, 0, toPatches(nodes, coefficients), y);
  for (std::size_t k = 0; k < 8; ++k) {
    // Sums of phi are rounded to half a ray per patch and function: at most a quarter of a ray off,
    // times a coefficient of 1.2, over some 100 patches with random signs.
    expectNear(y[k], expected(l.rays[k], x), 10.0 * 2 * 0.25 * 1.2 / 1024);
  }
}

}  // namespace
}  // namespace soffit::transfer

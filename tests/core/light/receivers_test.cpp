// SPDX-License-Identifier: MIT
#include "core/light/receivers.h"

#include "core/math/rng.h"
#include "core/math/sampling.h"

#include <gtest/gtest.h>

namespace soffit::light {
namespace {

struct Points {
  std::vector<vec3> positions, normals;
};

/// Points on the faces of boxes and on balls, as furniture has them.
Points manyPoints(std::size_t count) {
  Rng rng(7);
  Points p;
  for (std::size_t i = 0; i < count; ++i) {
    const auto axis = static_cast<int>(rng.uniform() * 2.999F);
    vec3 n(0.0F);
    n[axis] = rng.uniform() < 0.5F ? -1.0F : 1.0F;
    if (i % 5 == 0) n = uniformSphere(rng.uniform(), rng.uniform());
    p.positions.push_back(vec3(8, 5, 3) * vec3(rng.uniform(), rng.uniform(), rng.uniform()));
    p.normals.push_back(n);
  }
  return p;
}

/// What every grouping promises: each point once, padding, bounds that hold what they bound.
void expectSound(const Receivers& r, const Points& points, std::uint32_t most) {
  ASSERT_EQ(r.pointCount(), points.positions.size());
  ASSERT_EQ(r.groups.size() * Receivers::kGroup, r.slotCount());
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    const std::uint32_t slot = r.slot_of[i];
    EXPECT_EQ(r.point_of[slot], i);
    EXPECT_EQ(r.position(slot), points.positions[i]);
    EXPECT_EQ(r.normal(slot), points.normals[i]);
  }
  std::uint32_t next = 0;
  std::size_t used = 0;
  const auto expectBounds = [&](const Receivers::Bounds& b, std::uint32_t begin,
                                std::uint32_t end) {
    for (std::uint32_t s = begin; s < end; ++s) {
      EXPECT_TRUE(b.box.contains(r.position(s)));
      if (b.normal == vec3(0.0F)) continue;
      EXPECT_GT(glm::dot(b.normal, r.normal(s)), 0.999F);
      EXPECT_GE(glm::dot(b.normal, r.position(s)), b.plane_min - 1e-5F);
    }
  };
  for (const Receivers::Cluster& c : r.clusters) {
    EXPECT_EQ(c.begin, next);
    EXPECT_EQ((c.end - c.begin) % Receivers::kGroup, 0U);
    EXPECT_LE(c.used, c.end - c.begin);
    EXPECT_GT(c.used + Receivers::kGroup, c.end - c.begin);
    EXPECT_LE(c.end - c.begin, most);
    for (std::uint32_t s = c.begin + c.used; s < c.end; ++s) {
      EXPECT_EQ(r.position(s), r.position(c.begin + c.used - 1));  // padding repeats the last
    }
    expectBounds(c.bounds, c.begin, c.end);
    next = c.end;
    used += c.used;
  }
  EXPECT_EQ(next, r.slotCount());
  EXPECT_EQ(used, r.pointCount());
  for (std::uint32_t g = 0; g < r.groups.size(); ++g) {
    expectBounds(r.groups[g], g * Receivers::kGroup, (g + 1) * Receivers::kGroup);
  }
}

TEST(MakeReceivers, KeepsEveryPointOnceWithinItsBounds) {
  for (const std::size_t count : {0U, 1U, 15U, 16U, 17U, 3000U}) {
    const Points p = manyPoints(count);
    expectSound(makeReceivers(p.positions, p.normals, 64), p, 64);
  }
}

TEST(MakeReceivers, NeverMixesRegions) {
  const Points p = manyPoints(2000);
  std::vector<std::uint32_t> regions(p.positions.size());
  for (std::size_t i = 0; i < regions.size(); ++i) regions[i] = static_cast<std::uint32_t>(i % 7);
  const Receivers r = makeReceivers(p.positions, p.normals, 128, regions);
  expectSound(r, p, 128);
  for (const Receivers::Cluster& c : r.clusters) {
    for (std::uint32_t s = c.begin; s < c.end; ++s)
      EXPECT_EQ(regions[r.point_of[s]], regions[r.point_of[c.begin]]);
  }
}

TEST(MakeReceivers, TakesGivenClusters) {
  const Points p = manyPoints(100);
  std::vector<std::uint32_t> order(100);
  for (std::uint32_t i = 0; i < 100; ++i) order[i] = 99 - i;
  const std::vector<std::uint32_t> offsets = {0, 10, 60, 100};
  const Receivers r = makeReceivers(p.positions, p.normals, order, offsets);
  expectSound(r, p, 64);
  ASSERT_EQ(r.clusters.size(), 3U);
  EXPECT_EQ(r.clusters[1].used, 50U);
  EXPECT_EQ(r.point_of[r.clusters[1].begin], 89U);
}

TEST(MakeCompactReceivers, FillsItsGroupsAndKeepsThemSmall) {
  for (const std::size_t count : {0U, 1U, 17U, 256U, 5000U}) {
    const Points p = manyPoints(count);
    const Receivers r = makeCompactReceivers(p.positions, p.normals);
    expectSound(r, p, 1U << 20U);
    EXPECT_LT(r.slotCount(), count + Receivers::kGroup);  // every group but the last is full
  }
  const Points p = manyPoints(5000);
  const auto meanSize = [](const Receivers& r) {
    double sum = 0.0;
    for (const Receivers::Bounds& b : r.groups) sum += static_cast<double>(b.box.diagonal());
    return sum / static_cast<double>(r.groups.size());
  };
  const double compact = meanSize(makeCompactReceivers(p.positions, p.normals));
  // 313 groups in 120 m^3 that look one of six ways: cubes of 1.3 m; a third of a random group's 9
  // m.
  EXPECT_LT(compact, 3.5);
}

TEST(MakeCompactReceivers, DoesNotDependOnChance) {
  const Points p = manyPoints(3000);
  EXPECT_EQ(makeCompactReceivers(p.positions, p.normals).point_of,
            makeCompactReceivers(p.positions, p.normals).point_of);
}

}  // namespace
}  // namespace soffit::light

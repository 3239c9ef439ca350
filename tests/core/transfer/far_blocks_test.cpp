// SPDX-License-Identifier: MIT
#include "core/transfer/far_blocks.h"

#include "core/math/rng.h"
#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace soffit::transfer {
namespace {

using namespace testing;

struct Room {
  std::shared_ptr<const StaticScene> scene = sceneOf(blockRoom());
  Texels texels = makeTexels(*scene->mesh, scene->sides, 0.08, &scene->caster);
  FarBlocks blocks{texels, texels.area};
};

const Room& room() {
  static const Room r;
  return r;
}

/// The slots that an index stands for.
std::pair<std::size_t, std::size_t> rangeOf(const FarBlocks& blocks, std::size_t index) {
  const std::size_t slots = blocks.slotCount();
  if (index < slots) return {index, index + 1};
  if (index < slots + slots / 4) return {4 * (index - slots), 4 * (index - slots) + 4};
  const std::size_t k = index - slots - slots / 4;
  return {16 * k, 16 * k + 16};
}

TEST(FarBlocks, MeansKeepTheLightThatIsSent) {
  const Room& r = room();
  Rng rng(2);
  std::vector<vec4> x(r.blocks.size(), vec4(0.0F));
  for (std::size_t s = 0; s < r.blocks.slotCount(); ++s) {
    x[s] = {rng.uniform(), 2 * rng.uniform(), 100 * rng.uniform(), 0};
  }
  std::vector<float> plain(x.size() * 2);
  for (std::size_t s = 0; s < r.blocks.slotCount(); ++s) {
    plain[2 * s] = x[s].x;
    plain[2 * s + 1] = x[s].z;
  }
  r.blocks.average(0, r.blocks.slotCount(), x);
  r.blocks.average(0, r.blocks.slotCount(), 2, plain);
  int seen = 0;
  for (std::size_t k = r.blocks.slotCount(); k < r.blocks.size(); ++k) {
    const auto [begin, end] = rangeOf(r.blocks, k);
    double area = 0.0;
    dvec3 flux(0.0);
    for (std::size_t s = begin; s < end; ++s) {
      area += static_cast<double>(r.texels.area[s]);
      flux += static_cast<double>(r.texels.area[s]) * dvec3(x[s]);
    }
    if (area <= 0.0) continue;
    ++seen;
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(static_cast<double>(x[k][c]) * area, flux[c], 1e-6 * flux[c] + 1e-9);
    }
    EXPECT_FLOAT_EQ(plain[2 * k], x[k].x);
    EXPECT_FLOAT_EQ(plain[2 * k + 1], x[k].z);
  }
  EXPECT_GT(seen, 1000);
}

TEST(FarBlocks, ABlockHoldsWhatWasMetAndIsSeenAsOneRayOrAFew) {
  const Room& r = room();
  HemisphereScratch scratch;
  HemisphereHits hits;
  const vec3 p(3.0F, 2.0F, 0.0F);
  const vec3 n(0, 0, 1);
  for (const int side : {8, 32, 64}) {
    traceHemisphere(*r.scene, r.texels, p, n, side, 7, 0.0F, scratch, hits);
    std::vector<std::uint32_t> ends = hits.slots;
    const float share = 1.0F / static_cast<float>(ends.size());
    r.blocks.stepBack(r.texels, p, n, share, ends);
    std::set<std::uint32_t> different(ends.begin(), ends.end());
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (hits.slots[i] == kNoTexel) {
        EXPECT_EQ(ends[i], kNoTexel);
        continue;
      }
      const auto [begin, end] = rangeOf(r.blocks, ends[i]);
      EXPECT_TRUE(begin <= hits.slots[i] && hits.slots[i] < end);
      if (end - begin == 1) continue;
      double area = 0.0;
      double most = 0.0;
      for (std::size_t s = begin; s < end; ++s) {
        area += static_cast<double>(r.texels.area[s]);
        EXPECT_EQ(r.texels.part[s], r.texels.part[begin]);
        EXPECT_GT(glm::dot(r.texels.receivers.normal(s), r.texels.receivers.normal(begin)), 0.9F);
        most =
            std::max(most, static_cast<double>(glm::distance(r.texels.receivers.position(s), p)));
      }
      // Form factor of a small patch: A cos cos' / (pi d^2), at most so many rays of N.
      const dvec3 to = dvec3(r.texels.receivers.position(hits.slots[i]) - p);
      const double cosines =
          std::abs(to.z * glm::dot(to, dvec3(r.texels.receivers.normal(hits.slots[i])))) /
          glm::dot(to, to);
      const double rays =
          area * cosines / (std::numbers::pi * glm::dot(to, to)) / static_cast<double>(share);
      EXPECT_LE(rays, 16.5);
      EXPECT_LE(std::sqrt(area), 0.4 * most);
    }
    // Far fewer values to add up than rays.
    if (side > 8) {
      EXPECT_LT(different.size(), 0.6 * std::set(hits.slots.begin(), hits.slots.end()).size());
    }
  }
}

TEST(FarBlocks, NearTexelsStayThemselves) {
  const Room& r = room();
  const vec3 p(3.0F, 2.0F, 0.0F);
  std::vector<std::uint32_t> ends;
  for (std::uint32_t s = 0; s < r.blocks.slotCount(); ++s) {
    if (glm::distance(r.texels.receivers.position(s), p) < 0.3F) ends.push_back(s);
  }
  ASSERT_GT(ends.size(), 10U);
  const std::vector<std::uint32_t> before = ends;
  r.blocks.stepBack(r.texels, p, vec3(0, 0, 1), 1.0F / 1024.0F, ends);
  EXPECT_EQ(ends, before);
}

TEST(FarBlocks, CoveredTexelsAndStrangersMakeNoBlock) {
  const Room& r = room();
  std::vector<std::uint32_t> ends(r.blocks.slotCount());
  for (std::uint32_t s = 0; s < ends.size(); ++s) ends[s] = s;
  // One ray for everything: every block that may stand for its texels does.
  r.blocks.stepBack(r.texels, vec3(2, 1.5F, 200.0F), vec3(0, 0, 1), 1.0F, ends);
  std::size_t whole = 0;
  for (const std::uint32_t e : ends) {
    const auto [begin, end] = rangeOf(r.blocks, e);
    whole += end - begin == 16 ? 1 : 0;
    for (std::size_t s = begin; s < end; ++s) {
      if (r.texels.area[s] <= 0.0F) continue;
      EXPECT_EQ(r.texels.charts.chart_of[r.texels.triangle[s]],
                r.texels.charts.chart_of[r.texels.triangle[begin]]);
    }
  }
  // Most of a room of large surfaces is in blocks of 16.
  EXPECT_GT(whole, ends.size() / 2);
}

}  // namespace
}  // namespace soffit::transfer

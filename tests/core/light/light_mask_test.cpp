// SPDX-License-Identifier: MIT
// Visibility by bit masks and by points against rays to the same samples.
#include "core/light/light_mask.h"

#include "core/light/blocker_lanes.h"
#include "core/light/blockers.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace soffit::light {
namespace {

struct Group {
  std::array<std::vector<float>, 6> v;
  explicit Group(std::uint64_t seed) {
    Rng rng(seed);
    for (auto& list : v) list.resize(16);
    for (std::size_t i = 0; i < 16; ++i) {
      v[0][i] = 2 * rng.uniform() - 1;
      v[1][i] = 2 * rng.uniform() - 1;
      v[2][i] = 0.0F;
      v[5][i] = 1.0F;
    }
  }
  [[nodiscard]] MaskReceivers receivers() const {
    return {v[0].data(), v[1].data(), v[2].data(), v[3].data(), v[4].data(), v[5].data()};
  }
  [[nodiscard]] vec3 position(std::size_t i) const { return {v[0][i], v[1][i], v[2][i]}; }
};

std::vector<MaskBlocker> randomBlockers(std::uint64_t seed, int count, bool solid) {
  Rng rng(seed);
  std::vector<MaskBlocker> out;
  for (int i = 0; i < count; ++i) {
    Blocker b;
    const vec3 p(2 * rng.uniform() - 1, 2 * rng.uniform() - 1, 0.3F + 1.4F * rng.uniform());
    b.corners[0] = p;
    b.corners[1] = p + 0.6F * uniformSphere(rng.uniform(), rng.uniform());
    b.corners[2] = p + 0.6F * uniformSphere(rng.uniform(), rng.uniform());
    b.corners[3] = b.corners[2];
    for (vec3& c : b.corners) c.z = std::clamp(c.z, 0.1F, 1.9F);
    b.normal = glm::normalize(glm::cross(b.corners[1] - b.corners[0], b.corners[2] - b.corners[0]));
    b.solid = solid;
    out.push_back(maskBlocker(b));
  }
  return out;
}

/// Whether the segment meets the triangle; `close` when an edge or an end is within a rounding.
bool hides(const MaskBlocker& b, const vec3& from, const vec3& to, bool& close) {
  const dvec3 n(b.normal);
  const double h0 = glm::dot(n, dvec3(from)) - static_cast<double>(b.d);
  const double h1 = glm::dot(n, dvec3(to)) - static_cast<double>(b.d);
  if (b.solid && h0 <= 0.0) return false;  // only what lies behind its front is hidden
  if ((h0 > 0.0) == (h1 > 0.0)) return false;
  const dvec3 p = dvec3(from) + (dvec3(to) - dvec3(from)) * (h0 / (h0 - h1));
  double least = 1e300;
  for (int k = 0; k < b.count; ++k) {
    const dvec3 a(b.corners[static_cast<std::size_t>(k)]);
    const dvec3 e = dvec3(b.corners[static_cast<std::size_t>((k + 1) % b.count)]) - a;
    least = std::min(least, glm::dot(n, glm::cross(glm::normalize(e), p - a)));
  }
  close = close || std::abs(least) < 1e-4;
  return least > 0.0;
}

BlockerLanes lanesOf(const std::vector<MaskBlocker>& list) {
  BlockerLanes out;
  for (const MaskBlocker& b : list) out.push(b);
  return out;
}

/// Blockers in one call or, from one each, in many: the same shadow.
void addMaskVisibility(const MaskLight& light, const std::vector<MaskBlocker>& blockers,
                       const MaskReceivers& receivers, MaskSums& sums, bool one_by_one = false) {
  MaskShadow shadow(light, receivers);
  BlockerLanes lanes;
  for (const MaskBlocker& b : blockers) {
    lanes.push(b);
    if (!one_by_one) continue;
    shadow.hide(lanes, 1e-4F);
    lanes.clear();
  }
  shadow.hide(lanes, 1e-4F);
  shadow.addTo(sums);
}

TEST(MaskLight, SamplesFillTheLightAndCellsCountThem) {
  const MaskLight light =
      makeMaskLight({-0.5F, -0.3F, 2}, {1, 0, 0}, {0, 0.6F, 0}, {0, 0, -1}, true);
  vec3 mean(0.0F);
  for (int j = 0; j < MaskLight::kRows; ++j) {
    EXPECT_GE(MaskLight::rowOffset(j), 0.0F);
    EXPECT_LT(MaskLight::rowOffset(j), 1.0F);
    EXPECT_EQ(light.outline[static_cast<std::size_t>(j)], 0xffffffffU);
    for (int i = 0; i < MaskLight::kColumns; ++i) {
      const vec3 p = light.sample(j, i);
      EXPECT_TRUE(p.x >= -0.5F && p.x <= 0.5F && p.y >= -0.3F && p.y <= 0.3F + 1e-6F);
      mean += p / 512.0F;
    }
  }
  EXPECT_NEAR(mean.x, 0.0F, 1.0F / 32);
  EXPECT_NEAR(mean.y, 0.0F, 0.6F / 16);
  float bits = 0.0F;
  for (const float n : light.cell_count) bits += n;
  EXPECT_EQ(bits, 512.0F);
}

class MaskVisibility : public testing::TestWithParam<bool> {};

TEST_P(MaskVisibility, CountsTheBitsThatRaysCount) {
  const MaskLight light =
      makeMaskLight({-0.5F, -0.3F, 2}, {1, 0, 0}, {0, 0.6F, 0}, {0, 0, -1}, true);
  int doubtful = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Group group(seed);
    const auto blockers = randomBlockers(100 + seed, 1 + static_cast<int>(seed % 6), GetParam());
    MaskSums sums;
    addMaskVisibility(light, blockers, group.receivers(), sums, seed % 2 == 0);
    for (std::size_t i = 0; i < 16; ++i) {
      int visible = 0;
      int unsure = 0;
      for (int j = 0; j < MaskLight::kRows; ++j) {
        for (int k = 0; k < MaskLight::kColumns; ++k) {
          bool close = false;
          bool hidden = false;
          for (const MaskBlocker& b : blockers)
            hidden = hides(b, group.position(i), light.sample(j, k), close) || hidden;
          visible += hidden ? 0 : 1;
          unsure += close ? 1 : 0;
        }
      }
      doubtful += unsure;
      const double share =
          static_cast<double>(sums.plain_visible[i]) / static_cast<double>(sums.plain_total[i]);
      // Single precision may place an edge on the other side of a sample that it all but touches.
      EXPECT_NEAR(share, visible / 512.0, (unsure + 0.01) / 512.0);
      EXPECT_GE(sums.visible[i], 0.0F);
      EXPECT_LE(sums.visible[i], sums.total[i] * (1 + 1e-6F));
    }
  }
  EXPECT_LT(doubtful, 20 * 16 * 4);  // the comparison is a sharp one
}

INSTANTIATE_TEST_SUITE_P(SheetsAndSolids, MaskVisibility, testing::Bool());

TEST(MaskVisibility, WithoutBlockersEverythingIsVisible) {
  const MaskLight light =
      makeMaskLight({-0.5F, -0.3F, 2}, {1, 0, 0}, {0, 0.6F, 0}, {0, 0, -1}, true);
  const Group group(3);
  MaskSums sums;
  addMaskVisibility(light, {}, group.receivers(), sums);
  EXPECT_EQ(sums.visible, sums.total);
  EXPECT_EQ(sums.plain_visible, sums.plain_total);
  // Weights cos cos' / r^2 over the samples integrate to the form factor: compare two receivers'
  // ratio with the kernel at cell centres (16 of them).
  for (const std::size_t i : {1U, 5U}) {
    double expected[2] = {0, 0};
    for (std::size_t k = 0; k < 16; ++k) {
      for (int who = 0; who < 2; ++who) {
        const dvec3 d = dvec3(light.cell_center[k]) - dvec3(group.position(who == 0 ? 0 : i));
        expected[who] +=
            static_cast<double>(light.cell_count[k]) * d.z * d.z / std::pow(glm::dot(d, d), 2);
      }
    }
    EXPECT_NEAR(static_cast<double>(sums.total[i] / sums.total[0]), expected[1] / expected[0],
                1e-5);
  }
}

TEST(MaskVisibility, AWallHidesAllAndSumsAdd) {
  const MaskLight light =
      makeMaskLight({-0.5F, -0.3F, 2}, {1, 0, 0}, {0, 0.6F, 0}, {0, 0, -1}, true);
  const Group group(4);
  Blocker wall;
  wall.corners = {vec3(-9, -9, 1), vec3(9, -9, 1), vec3(9, 9, 1), vec3(-9, 9, 1)};
  wall.count = 4;
  wall.normal = {0, 0, 1};
  const std::vector<MaskBlocker> list = {maskBlocker(wall)};
  MaskSums sums;
  addMaskVisibility(light, list, group.receivers(), sums);
  for (const float v : sums.visible) EXPECT_EQ(v, 0.0F);
  for (const float v : sums.plain_visible) EXPECT_EQ(v, 0.0F);
  const MaskSums once = sums;
  addMaskVisibility(light, {}, group.receivers(), sums);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_NEAR(sums.visible[i], once.total[i], 1e-6F * once.total[i]);
    EXPECT_NEAR(sums.total[i], 2 * once.total[i], 1e-6F * once.total[i]);
  }
}

TEST(PointVisibility, CountsThePointsThatRaysCount) {
  PointLightSamples points;
  Rng rng(9);
  for (int k = 0; k < 64; ++k) {
    const vec3 n = uniformSphere(rng.uniform(), rng.uniform());
    points.x.push_back(0.2F * n.x);
    points.y.push_back(0.2F * n.y);
    points.z.push_back(2.2F + 0.2F * n.z);
    points.nx.push_back(0);
    points.ny.push_back(0);
    points.nz.push_back(0);
    points.weight.push_back(1.0F);
  }
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Group group(seed);
    const auto blockers = randomBlockers(200 + seed, 3, seed % 2 == 0);
    MaskSums sums;
    addPointVisibility(points, lanesOf(blockers), group.receivers(), 1e-4F, sums);
    for (std::size_t i = 0; i < 16; ++i) {
      double visible = 0.0;
      double total = 0.0;
      double unsure = 0.0;
      for (std::size_t k = 0; k < 64; ++k) {
        const vec3 to(points.x[k], points.y[k], points.z[k]);
        const dvec3 d = dvec3(to) - dvec3(group.position(i));
        const double weight =
            d.z / std::pow(glm::dot(d, d), 1.5);  // cos / r^2, no cosine at the light
        bool close = false;
        bool hidden = false;
        for (const MaskBlocker& b : blockers)
          hidden = hides(b, group.position(i), to, close) || hidden;
        total += weight;
        if (!hidden) visible += weight;
        if (close) unsure += weight;
      }
      EXPECT_NEAR(static_cast<double>(sums.visible[i] / sums.total[i]), visible / total,
                  unsure / total + 1e-4);
    }
  }
}

TEST(MaskShadow, TellsWhenNothingIsSeenAnyMore) {
  const MaskLight light =
      makeMaskLight({-0.5F, -0.3F, 2}, {1, 0, 0}, {0, 0.6F, 0}, {0, 0, -1}, true);
  const Group group(3);
  MaskReceivers r = group.receivers();
  r.lanes = 0x0ff0U;
  MaskShadow shadow(light, r);
  BlockerLanes halves;
  // Two walls that overlap in the middle, each of which leaves some of the light to some receiver.
  for (const float sign : {-1.0F, 1.0F}) {
    Blocker half;
    half.corners = {vec3(-0.01F * sign, -9, 1), vec3(9 * sign, -9, 1), vec3(9 * sign, 9, 1),
                    vec3(-0.01F * sign, 9, 1)};
    half.count = 4;
    half.normal = vec3(0, 0, sign);
    halves.clear();
    halves.push(maskBlocker(half));
    EXPECT_EQ(shadow.hide(halves, 1e-4F), sign > 0.0F);
  }
  MaskSums sums;
  shadow.addTo(sums);
  for (std::size_t i = 0; i < 16; ++i)
    EXPECT_EQ(sums.visible[i], i < 4 || i >= 12 ? sums.total[i] : 0.0F);
}

TEST(BlockerLanes, GiveBackWhatTheyWereGiven) {
  const std::vector<MaskBlocker> list = randomBlockers(9, 70, true);
  BlockerLanes lanes;
  for (const MaskBlocker& b : list) lanes.push(b);
  lanes.swap(3, 66);
  ASSERT_EQ(lanes.size(), list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const MaskBlocker& b = list[i == 3 ? 66 : (i == 66 ? 3 : i)];
    const MaskBlocker found = lanes.at(i);
    EXPECT_EQ(found.count, b.count);
    EXPECT_EQ(found.normal, b.normal);
    EXPECT_EQ(found.d, b.d);
    EXPECT_EQ(found.solid, b.solid);
    for (std::size_t c = 0; c < static_cast<std::size_t>(b.count); ++c) {
      EXPECT_EQ(found.corners[c], b.corners[c]);
    }
  }
}

}  // namespace
}  // namespace soffit::light

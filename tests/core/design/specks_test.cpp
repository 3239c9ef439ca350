// SPDX-License-Identifier: MIT
#include "core/design/specks.h"

#include "core/design/contours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace soffit::design {
namespace {

constexpr int kSide = 40;
constexpr double kLevel = 500.0;

std::vector<float> sampled(auto f) {
  std::vector<float> values;
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      values.push_back(static_cast<float>(f(static_cast<double>(i), static_cast<double>(j))));
    }
  }
  return values;
}

/// The grid as triangles.
Neighbours triangulated() {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t j = 0; j + 1 < kSide; ++j) {
    for (std::uint32_t i = 0; i + 1 < kSide; ++i) {
      const std::uint32_t a = j * kSide + i;
      for (const std::uint32_t k : {a, a + 1, a + kSide, a + 1, a + kSide + 1, a + kSide}) {
        indices.push_back(k);
      }
    }
  }
  return meshNeighbours(std::size_t{kSide} * kSide, indices);
}

std::vector<float> flattened(std::vector<float> values) {
  const std::vector<double> levels{kLevel};
  for (const FlattenedPoint& p : findSpecks(values, triangulated(), levels)) {
    values[p.point] = p.value;
  }
  return values;
}

std::vector<Contour> lines(const std::vector<float>& values) {
  return contoursAt(std::vector<double>(values.begin(), values.end()), kSide, kSide, kLevel);
}

std::vector<Contour> kept(const std::vector<float>& values) {
  return withoutSpecks(lines(values), std::vector<double>(values.begin(), values.end()), kSide,
                       kLevel);
}

/// 480 lx on the left to 520 lx on the right, with 0.4 % of noise: a wide band is near the level.
std::vector<float> noisy(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-2.0, 2.0);
  return sampled([&](double i, double) {
    return kLevel + 20.0 * std::tanh((i - 19.6) / 8.0) * std::abs(i - 19.6) / 20.0 + noise(random);
  });
}

TEST(Specks, OfNoiseAboutALevelGoAndTheLinesThatAreRealStayBitForBit) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto values = noisy(seed);
    const auto before = lines(values);
    const auto after = kept(values);
    std::size_t gone = 0;
    for (const Contour& line : before) {
      const bool stays = std::ranges::any_of(after, [&](const Contour& other) {
        return other.closed == line.closed && other.points == line.points;
      });
      if (stays) continue;
      ++gone;
      EXPECT_TRUE(line.closed);
      // About 16 points at most: a line crosses four edges about one, and fewer per point of more.
      EXPECT_LE(line.points.size(), 4U * 16U);
    }
    EXPECT_GT(gone, 5U);
    EXPECT_EQ(after.size(), before.size() - gone);
    EXPECT_TRUE(std::ranges::any_of(after, [](const Contour& line) { return !line.closed; }));
  }
}

TEST(Specks, OfAMeshAreAllGoneAfterOnce) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto once = flattened(noisy(seed));
    EXPECT_NE(once, noisy(seed));
    EXPECT_LT(lines(once).size(), lines(noisy(seed)).size());
  }
}

TEST(Specks, ASpotOfOnePointThatIsDeeperThanTheErrorStays) {
  const auto spot = [](double height) {
    return sampled([&](double i, double j) { return i == 20.0 && j == 12.0 ? height : 490.0; });
  };
  EXPECT_EQ(kept(spot(1.02 * kLevel)).size(), lines(flattened(spot(1.02 * kLevel))).size());
  EXPECT_EQ(kept(spot(1.02 * kLevel)).size(), 1U);
  EXPECT_EQ(kept(spot(1.005 * kLevel)).size(), lines(flattened(spot(1.005 * kLevel))).size());
  EXPECT_EQ(kept(spot(1.005 * kLevel)).size(), 0U);
  // A shadow likewise.
  const auto hole = [](double depth) {
    return sampled([&](double i, double j) { return i == 20.0 && j == 12.0 ? depth : 505.0; });
  };
  EXPECT_EQ(kept(hole(0.98 * kLevel)).size(), lines(flattened(hole(0.98 * kLevel))).size());
  EXPECT_EQ(kept(hole(0.98 * kLevel)).size(), 1U);
  EXPECT_EQ(kept(hole(0.995 * kLevel)).size(), lines(flattened(hole(0.995 * kLevel))).size());
  EXPECT_EQ(kept(hole(0.995 * kLevel)).size(), 0U);
}

TEST(Specks, WhatIsWideStaysHoweverShallow) {
  const auto pond = [](double radius) {
    return sampled([&](double i, double j) {
      return std::hypot(i - 20.0, j - 20.0) <= radius ? 1.001 * kLevel : 0.999 * kLevel;
    });
  };
  EXPECT_EQ(kept(pond(1.5)).size(), lines(flattened(pond(1.5))).size());
  EXPECT_EQ(kept(pond(1.5)).size(), 0U);  // 9 points
  EXPECT_EQ(kept(pond(2.5)).size(), lines(flattened(pond(2.5))).size());
  EXPECT_EQ(kept(pond(2.5)).size(), 1U);  // 21 points
  EXPECT_EQ(kept(pond(10.0)).size(), lines(flattened(pond(10.0))).size());
  EXPECT_EQ(kept(pond(10.0)).size(), 1U);
}

TEST(Specks, TheBorderIsNoLoop) {
  const auto values = sampled(
      [](double i, double j) { return i < 2.0 && j == 12.0 ? 1.001 * kLevel : 0.999 * kLevel; });
  EXPECT_EQ(lines(values).size(), 1U);
  EXPECT_EQ(kept(values).size(), 1U);
  EXPECT_EQ(flattened(values), values);
}

TEST(Specks, SmoothLightIsLeftAlone) {
  EXPECT_EQ(flattened(sampled([](double i, double j) { return 12.0 * i + 3.0 * j; })),
            sampled([](double i, double j) { return 12.0 * i + 3.0 * j; }));
  const auto hill = sampled([](double i, double j) {
    return 600.0 - 0.6 * ((i - 20.0) * (i - 20.0) + (j - 20.0) * (j - 20.0));
  });
  EXPECT_EQ(flattened(hill), hill);
  EXPECT_EQ(kept(hill).size(), lines(hill).size());
}

TEST(Specks, NoValueChangesByMoreThanTheError) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 50; ++trial) {
    std::normal_distribution<double> noise(0.0, 1.0 + 0.3 * trial);
    const auto values = sampled([&](double, double) { return kLevel + noise(random); });
    const auto after = flattened(values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] == after[i]) continue;
      EXPECT_LE(std::abs(static_cast<double>(values[i]) - kLevel), 0.01 * kLevel);
      EXPECT_LE(std::abs(static_cast<double>(after[i]) - kLevel), 0.01 * kLevel * (1.0 + 1e-6));
      EXPECT_NE(static_cast<double>(values[i]) >= kLevel, static_cast<double>(after[i]) >= kLevel);
    }
    EXPECT_LE(lines(after).size(), lines(values).size());
  }
}

TEST(Specks, OfAMeshHangTogetherByItsEdges) {
  const Neighbours mesh = triangulated();
  for (std::uint32_t p = 0; p < mesh.border.size(); ++p) {
    const std::uint32_t i = p % kSide;
    const std::uint32_t j = p / kSide;
    EXPECT_EQ(mesh.border[p] != 0, i == 0 || j == 0 || i + 1 == kSide || j + 1 == kSide);
  }
  // Two edges along each axis and one diagonal's.
  const std::size_t inner = 5 * kSide + 7;
  EXPECT_EQ(mesh.first[inner + 1] - mesh.first[inner], 6U);
  const auto values =
      sampled([](double i, double j) { return i == 20.0 && j == 12.0 ? 1.005 * kLevel : 495.0; });
  const std::vector<double> levels{100.0, kLevel};
  const auto found = findSpecks(values, mesh, levels);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().point, 12U * kSide + 20U);
  EXPECT_EQ(found.front().value, 495.0F);
}

TEST(Specks, NothingIsNoFault) {
  EXPECT_TRUE(findSpecks({}, meshNeighbours(0, {}), {}).empty());
  // A point without neighbours has nothing to be like.
  const Neighbours lonely = meshNeighbours(1, {});
  EXPECT_TRUE(findSpecks(std::vector<float>{500.0F}, lonely, std::vector<double>{kLevel}).empty());
}

}  // namespace
}  // namespace soffit::design

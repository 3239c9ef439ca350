// SPDX-License-Identifier: MIT
#include "core/design/bench_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace soffit::design {
namespace {

TEST(BenchPlan, NoPointIsMeasuredTwice) {
  std::set<std::string> names;
  for (const BenchStep& step : benchPlan()) {
    for (const BenchPoint& point : step.points) {
      const std::string name = point.methodName() + " " + point.settingsName();
      EXPECT_TRUE(names.insert(name).second) << name;
    }
  }
}

TEST(BenchPlan, SweepsThePapersMethodsFromEndToEnd) {
  std::set<int> bands_of_harmonics, bands_of_cubes, sides, directions;
  for (const BenchStep& step : benchPlan()) {
    for (const BenchPoint& point : step.points) {
      if (point.method == BenchMethod::harmonics) {
        bands_of_harmonics.insert(point.rays);
        directions.insert(point.resolution);
      } else if (point.method == BenchMethod::cubes) {
        bands_of_cubes.insert(point.rays);
        sides.insert(point.resolution);
      }
    }
  }
  EXPECT_THAT(bands_of_harmonics, testing::IsSupersetOf({2, 3, 4, 5, 6, 8, 10}));
  EXPECT_THAT(bands_of_cubes, testing::IsSupersetOf({2, 3, 4, 5, 6, 8, 10}));
  EXPECT_THAT(sides, testing::IsSupersetOf({8, 32, 64})) << "0 is 16";
  EXPECT_THAT(directions, testing::IsSupersetOf({256, 4096})) << "0 is 1024";
}

TEST(BenchPlan, NamesTellMethodsApart) {
  EXPECT_EQ((BenchPoint{BenchMethod::cubes, 5, {}}).methodName(), "cubes-5");
  EXPECT_EQ((BenchPoint{BenchMethod::cubes, 5, {}, 32}).methodName(), "cubes-5-side-32");
  EXPECT_EQ((BenchPoint{BenchMethod::harmonics, 3, {}, 256}).methodName(),
            "harmonics-3-directions-256");
}

}  // namespace
}  // namespace soffit::design

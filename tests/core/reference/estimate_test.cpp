// SPDX-License-Identifier: MIT
#include "core/reference/estimate.h"

#include "core/base/parallel.h"
#include "rooms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::reference {
namespace {

using test::luminaire;

ReferenceScene room() {
  const auto scene = test::Builder()
                         .box({0, 0, 0}, {4, 3, 2.5}, test::matte(0.6))
                         .box({1.5, 1, 0.6}, {2.5, 2, 1.1}, test::matte(0.3))
                         .scene();
  return test::prepare(scene, {luminaire(light::Rectangle{0.5, 0.5}, {1, 1, 2.4}),
                               luminaire(light::Sphere{0.05}, {3.2, 2.2, 1.9}, 300)});
}

std::vector<scene::Sensor> grid() {
  std::vector<scene::Sensor> out;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 6; ++j) out.push_back({{0.25 + 0.5 * i, 0.25 + 0.5 * j, 0.02}, {0, 0, 1}});
  }
  return out;
}

TEST(Estimate, TwoRunsDifferByWhatTheirErrorsSay) {
  EstimateOptions options;
  options.relative_error = 0.03;
  const ReferenceScene scene = room();
  const Estimate a = estimate(scene, grid(), options);
  options.seed = 2;
  const Estimate b = estimate(scene, grid(), options);
  double squares = 0.0;
  for (std::size_t i = 0; i < a.sensors.size(); ++i) {
    const double spread = std::hypot(a.sensors[i].standard_error, b.sensors[i].standard_error);
    squares += std::pow((a.sensors[i].total - b.sensors[i].total) / spread, 2);
  }
  // Statistical: the mean of 48 squares is 1 within 0.2; errors from 16 replicates widen it a bit.
  EXPECT_NEAR(std::sqrt(squares / double(a.sensors.size())), 1.0, 0.35);
}

TEST(Estimate, ReachesTheWantedError) {
  EstimateOptions options;
  options.relative_error = 0.015;
  const Estimate e = estimate(room(), grid(), options);
  EXPECT_TRUE(e.reached);
  double mean = 0.0;
  for (const SensorEstimate& s : e.sensors) mean += s.total / double(e.sensors.size());
  for (const SensorEstimate& s : e.sensors) {
    EXPECT_LE(s.standard_error, 0.015 * std::max(s.total, 0.05 * mean));
    EXPECT_DOUBLE_EQ(s.total, s.direct + s.indirect);
    EXPECT_GE(s.replicates, 16);
  }
  EXPECT_GT(e.rays, e.paths);
}

TEST(Estimate, DoesNotDependOnTheThreadCount) {
  EstimateOptions options;
  options.relative_error = 0.03;
  const ReferenceScene scene = room();
  setThreadCount(1);
  const Estimate one = estimate(scene, grid(), options);
  setThreadCount(0);
  const Estimate all = estimate(scene, grid(), options);
  for (std::size_t i = 0; i < one.sensors.size(); ++i) {
    EXPECT_EQ(one.sensors[i].total, all.sensors[i].total);
    EXPECT_EQ(one.sensors[i].standard_error, all.sensors[i].standard_error);
  }
  EXPECT_EQ(one.rays, all.rays);
}

TEST(Estimate, StopsAtTheTimeLimitWithWhatItHas) {
  EstimateOptions options;
  options.relative_error = 1e-6;
  options.time_limit_s = 1e-9;
  const Estimate e = estimate(room(), grid(), options);
  EXPECT_FALSE(e.reached);
  for (const SensorEstimate& s : e.sensors) {
    EXPECT_GE(s.replicates, 2);
    EXPECT_GT(s.total, 0.0);
    EXPECT_TRUE(std::isfinite(s.standard_error));
  }
}

TEST(Estimate, StopsAtTheMostPaths) {
  EstimateOptions options;
  options.relative_error = 1e-6;
  options.paths_per_replicate = 64;
  options.max_paths = 64 * 20;
  const Estimate e = estimate(room(), grid(), options);
  EXPECT_FALSE(e.reached);
  for (const SensorEstimate& s : e.sensors) EXPECT_EQ(s.replicates, 20);
}

TEST(Estimate, GivesUpWhenCancelled) {
  std::stop_source source;
  source.request_stop();
  Job job;
  job.stop = source.get_token();
  const Estimate e = estimate(room(), grid(), {}, job);
  EXPECT_FALSE(e.reached);
  EXPECT_EQ(e.sensors.size(), grid().size());
  EXPECT_EQ(e.sensors[0].total, 0.0);
}

TEST(Estimate, OfNothingIsNothing) {
  EXPECT_TRUE(estimate(room(), {}, {}).reached);
  const ReferenceScene dark = test::prepare(test::Builder().scene(), {});
  const SensorEstimate e = test::measure(dark, {dvec3(0), dvec3(0, 0, 1)}, {});
  EXPECT_EQ(e.total, 0.0);
  EXPECT_EQ(e.standard_error, 0.0);
}

TEST(Estimate, SubtractsTheOriginOfTheMesh) {
  auto here = test::Builder().box({0, 0, 0}, {4, 3, 2.5}, test::matte(0.6)).scene();
  auto there = here;
  auto moved = std::make_shared<geometry::Mesh>(*here.mesh);
  moved->origin = dvec3(500000, 5000000, 100);
  there.mesh = moved;
  EstimateOptions options;
  options.min_replicates = 2;
  options.relative_error = 1.0;
  const light::Shape panel = light::Rectangle{0.5, 0.5};
  const SensorEstimate a = test::measure(test::prepare(here, {luminaire(panel, {1, 1, 2.4})}),
                                         {{2, 2, 0.5}, {0, 0, 1}}, options);
  const SensorEstimate b =
      test::measure(test::prepare(there, {luminaire(panel, dvec3(1, 1, 2.4) + moved->origin)}),
                    {dvec3(2, 2, 0.5) + moved->origin, {0, 0, 1}}, options);
  EXPECT_NEAR(a.total, b.total, 1e-5 * a.total);  // round-off of the far coordinates, 1e-9 m
}

TEST(ReferenceScene, PassesOnWhatIsWrongWithALuminaire) {
  const auto made = ReferenceScene::make(test::Builder().scene(),
                                         std::vector{luminaire(light::Sphere{0.0}, dvec3(0))});
  ASSERT_FALSE(made.ok());
  EXPECT_THAT(made.error().message(), testing::HasSubstr("luminaires.L.shape.sphere"));
}

}  // namespace
}  // namespace soffit::reference

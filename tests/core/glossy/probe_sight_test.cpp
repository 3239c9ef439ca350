// SPDX-License-Identifier: MIT
#include "core/glossy/probe_sight.h"

#include "core/math/rng.h"
#include "core/math/sampling.h"
#include "core/sh/cube_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace soffit::glossy {
namespace {

ProbeDepth depthOf(const std::function<float(const vec3&)>& distance) {
  constexpr int kSide = 128;
  std::vector<float> distances;
  for (const dvec3& d : sh::cubeSamples(kSide).directions) distances.push_back(distance(vec3(d)));
  return {kSide, distances};
}

TEST(ProbeSight, AWholeRoomIsSeenAndWhatLiesBehindItsWallsIsNot) {
  const Box room{vec3(-3.0F, -2.0F, -1.5F), vec3(4.0F, 2.5F, 1.3F)};
  const ProbeSight sight(
      depthOf([&](const vec3& d) { return distanceToBox(room, vec3(0.0F), d).value(); }));
  Rng rng(3);
  for (int k = 0; k < 2000; ++k) {
    const vec3 d =
        uniformSphere(static_cast<float>(rng.uniform()), static_cast<float>(rng.uniform()));
    const float wall = distanceToBox(room, vec3(0.0F), d).value();
    // Slanted walls and corners have places farther and nearer about them.
    EXPECT_GT(sight.of(wall * d), 0.5F) << d.x << ' ' << d.y << ' ' << d.z;
    EXPECT_EQ(sight.of(0.5F * wall * d), 1.0F);
    EXPECT_LT(sight.of(2.0F * wall * d), 0.1F);
  }
}

TEST(ProbeSight, FallsEvenlyOverTheEdgeOfWhatHidesAPlace) {
  // A screen a metre away over half of the sphere, everything else three metres away.
  const ProbeSight sight(depthOf([](const vec3& d) { return d.z < 0.0F ? 1.0F : 3.0F; }));
  float before = 0.0F;
  float steepest = 0.0F;
  constexpr int kSteps = 200;
  for (int k = 0; k <= kSteps; ++k) {
    const float angle = 0.2F * (2.0F * static_cast<float>(k) / kSteps - 1.0F);
    const float share = sight.of(3.0F * vec3(std::cos(0.3F) * std::cos(angle),
                                             std::sin(0.3F) * std::cos(angle), std::sin(angle)));
    if (angle < -0.11F) {
      EXPECT_LT(share, 0.02F) << angle;
    } else if (angle > 0.13F) {
      EXPECT_GT(share, 0.98F) << angle;
    }
    EXPECT_GE(share, before - 1e-3F) << angle;
    steepest = std::max(steepest, share - before);
    before = share;
  }
  EXPECT_LT(steepest, 0.05F) << "of 2 mrad: no edge";
}

TEST(ProbeSight, NothingThereHidesNothing) {
  const ProbeSight sight(
      depthOf([](const vec3&) { return std::numeric_limits<float>::infinity(); }));
  EXPECT_EQ(sight.of({10.0F, 20.0F, -3.0F}), 1.0F);
  EXPECT_EQ(sight.of({0.0F, 0.0F, 0.0F}), 1.0F);
}

}  // namespace
}  // namespace soffit::glossy

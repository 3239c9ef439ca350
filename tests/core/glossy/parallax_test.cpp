// SPDX-License-Identifier: MIT
#include "core/glossy/parallax.h"

#include "core/glossy/first_hits.h"
#include "core/sh/cube_map.h"
#include "tests/core/glossy/random_directions.h"
#include "tests/core/glossy/test_box.h"

#include <gtest/gtest.h>

#include <limits>

#include <array>
#include <cmath>

namespace soffit::glossy {
namespace {

Box room() {
  Box box;
  box.add(vec3(0.0F));
  box.add(vec3(4.0F, 3.0F, 2.5F));
  return box;
}

TEST(Parallax, LooksTowardThePlaceThatTheRayMeets) {
  const geometry::RayCaster walls = boxCaster(room().lo, room().hi);
  Rng rng(2);
  const vec3 probe(2.0F, 1.5F, 1.2F);
  for (int k = 0; k < 500; ++k) {
    const vec3 p(4.0F * rng.uniform(), 3.0F * rng.uniform(), 2.5F * rng.uniform());
    const vec3 d(randomDirection(rng));
    const geometry::Hit hit = walls.closest(geometry::Ray{p, 0.0F, d});
    if (!hit.valid()) continue;
    const vec3 place = p + hit.t * d;
    const Lookup lookup = throughBox(room(), probe, p, d);
    EXPECT_NEAR(glm::length(lookup.direction - glm::normalize(place - probe)), 0.0F, 1e-4F);
    EXPECT_NEAR(lookup.width, hit.t / glm::length(place - probe), 1e-3F);
  }
}

TEST(Parallax, AtTheProbeNothingChangesAndOutsideTheBoxNeither) {
  const vec3 probe(2.0F, 1.5F, 1.2F);
  const vec3 d = glm::normalize(vec3(1.0F, 2.0F, -0.5F));
  const Lookup same = throughBox(room(), probe, probe, d);
  EXPECT_NEAR(glm::length(same.direction - d), 0.0F, 1e-6F);
  EXPECT_NEAR(same.width, 1.0F, 1e-5F);
  const Lookup outside = throughBox(room(), probe, vec3(10.0F, 0.0F, 0.0F), d);
  EXPECT_EQ(outside.direction, d);
  EXPECT_EQ(outside.width, 1.0F);
  // A receiver in the wall itself, looking along it and away from it.
  EXPECT_NEAR(distanceToBox(room(), vec3(1.0F, 1.0F, 0.0F), vec3(1, 0, 0)).value(), 3.0F, 1e-5F);
  EXPECT_NEAR(distanceToBox(room(), vec3(1.0F, 1.0F, 0.0F), vec3(0, 0, -1)).value(), 0.0F, 1e-5F);
}

TEST(ProbeDepth, FindsAPartitionThatTheBoxDoesNotKnow) {
  // A box within the room's box: the probe sees the inner walls, the proxy is larger by a metre.
  const geometry::RayCaster inner = boxCaster({1, 0, 0}, {3, 3, 2.5F});
  const vec3 probe(2.0F, 1.5F, 1.2F);
  const auto samples = std::make_shared<const sh::SphereSamples>(sh::cubeSamples(64));
  const std::array<vec3, 1> at{probe};
  const FirstHits first(inner, at, {}, samples);
  std::vector<float> distances;
  for (const geometry::Hit& hit : first.hits(0)) distances.push_back(hit.t);
  const ProbeDepth depth(64, distances);
  Rng rng(3);
  double by_box = 0.0, by_depth = 0.0;
  constexpr int kRays = 300;
  for (int k = 0; k < kRays; ++k) {
    const vec3 p(1.3F + 1.4F * rng.uniform(), 0.3F + 2.4F * rng.uniform(), 0.01F);
    vec3 d(randomDirection(rng));
    d.z = std::abs(d.z);
    const geometry::Hit hit = inner.closest(geometry::Ray{p, 0.0F, d});
    const vec3 exact = glm::normalize(p + hit.t * d - probe);
    const float far = distanceToBox(room(), p, d).value();
    by_box += static_cast<double>(glm::length(throughBox(room(), probe, p, d).direction - exact));
    by_depth +=
        static_cast<double>(glm::length(depth.throughDepth(probe, p, d, far).direction - exact));
  }
  // Mean angle: planes are exact but for the room's edges, where a texel (0.024 rad) holds two,
  // and 1 % behind counts as on the surface.
  EXPECT_LT(by_depth / kRays, 0.01);
  EXPECT_LT(by_depth, 0.1 * by_box);
}

TEST(ProbeDepth, PlanesAreExactAcrossFacesAndNothingIsInfinite) {
  const vec3 normal = glm::normalize(vec3(0.3F, 0.5F, 1.0F));
  constexpr float kAway = 1.7F;
  constexpr int kSide = 16;
  const auto along = [&](const dvec3& d) {
    const double slope = glm::dot(d, dvec3(normal));
    return slope > 0.0 ? static_cast<float>(static_cast<double>(kAway) / slope)
                       : std::numeric_limits<float>::infinity();
  };
  std::vector<float> distances;
  for (const dvec3& d : sh::cubeSamples(kSide).directions) distances.push_back(along(d));
  const ProbeDepth depth(kSide, distances);
  Rng rng(5);
  double most = 0.0, sum = 0.0;
  for (int k = 0; k < 2000; ++k) {
    const dvec3 d = randomDirection(rng);
    const double slope = glm::dot(d, dvec3(normal));
    // Near the horizon a texel holds both.
    if (slope > 0.3) {
      const double off = std::abs(static_cast<double>(depth.toward(vec3(d)) / along(d)) - 1.0);
      most = std::max(most, off);
      sum += off;
    }
    if (slope < -0.3) {
      EXPECT_TRUE(std::isinf(depth.toward(vec3(d))));
    }
  }
  // Exact but for the corners of the rims.
  EXPECT_LT(sum / 2000, 1e-4);
  EXPECT_LT(most, 5e-3);
}

}  // namespace
}  // namespace soffit::glossy

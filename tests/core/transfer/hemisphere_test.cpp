// SPDX-License-Identifier: MIT
#include "core/transfer/hemisphere.h"

#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace soffit::transfer {
namespace {

using namespace testing;

struct Room {
  std::shared_ptr<const StaticScene> scene;
  Texels texels;
};

const Room& room() {
  static const Room r = [] {
    geometry::Mesh mesh;
    append(mesh, roomBox({0, 0, 0}, {4, 3, 2.5F}), 0);
    Room out{sceneOf(std::move(mesh)), {}};
    out.texels = makeTexels(*out.scene->mesh, out.scene->sides, 0.1, &out.scene->caster);
    return out;
  }();
  return r;
}

HemisphereHits trace(const vec3& p, const vec3& n, int side, std::uint64_t seed, float gap = 0.0F) {
  HemisphereScratch scratch;
  HemisphereHits hits;
  traceHemisphere(*room().scene, room().texels, p, n, side, seed, gap, scratch, hits);
  return hits;
}

TEST(TraceHemisphere, SharesAreFormFactors) {
  const HemisphereHits hits = trace({2, 1.5F, 0}, {0, 0, 1}, 64, 5);
  ASSERT_EQ(hits.slots.size(), 64U * 64U);
  EXPECT_EQ(hits.missed, 0);
  EXPECT_EQ(hits.inside, 0);
  double ceiling = 0.0;
  for (const std::uint32_t s : hits.slots) {
    ASSERT_NE(s, kNoTexel);
    ceiling += room().texels.receivers.normal(s).z < -0.5F ? 1.0 : 0.0;
  }
  ceiling /= static_cast<double>(hits.slots.size());
  // A rectangle opposite a point under its centre, four quarters a x b at c (Howell B-4).
  const double a = 2.0 / 2.5;
  const double b = 1.5 / 2.5;
  const double quarter = (a / std::sqrt(1 + a * a) * std::atan(b / std::sqrt(1 + a * a)) +
                          b / std::sqrt(1 + b * b) * std::atan(a / std::sqrt(1 + b * b))) /
                         (2.0 * std::numbers::pi);
  // Stratified: the error of an area with an edge falls as N^-3/4, about 2e-3 for 4096 rays; 4 of
  // it.
  EXPECT_NEAR(ceiling, 4 * quarter, 8e-3);
}

TEST(TraceHemisphere, IsTheSameForTheSameSeed) {
  EXPECT_EQ(trace({1, 1, 0}, {0, 0, 1}, 8, 3).slots, trace({1, 1, 0}, {0, 0, 1}, 8, 3).slots);
  EXPECT_NE(trace({1, 1, 0}, {0, 0, 1}, 8, 3).slots, trace({1, 1, 0}, {0, 0, 1}, 8, 4).slots);
}

TEST(TraceHemisphere, WhatLeavesTheSceneIsCounted) {
  // From outside, away from the room.
  const HemisphereHits hits = trace({2, 1.5F, 2.6F}, {0, 0, 1}, 8, 1);
  EXPECT_EQ(hits.missed, 64);
  for (const std::uint32_t s : hits.slots) EXPECT_EQ(s, kNoTexel);
}

TEST(TraceHemisphere, TheInsideOfASolidIsCounted) {
  geometry::Mesh mesh = blockRoom();
  const auto scene = sceneOf(std::move(mesh));
  const Texels texels = makeTexels(*scene->mesh, scene->sides, 0.1, &scene->caster);
  HemisphereScratch scratch;
  HemisphereHits hits;
  traceHemisphere(*scene, texels, {1.5F, 1.25F, 1.0F}, {0, 0, 1}, 8, 1, 0.0F, scratch, hits);
  EXPECT_EQ(hits.inside, 64);
  for (const std::uint32_t s : hits.slots) EXPECT_EQ(s, kNoTexel);
}

}  // namespace
}  // namespace soffit::transfer

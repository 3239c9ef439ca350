// SPDX-License-Identifier: MIT
#include "core/prt/vertex_receivers.h"

#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::matte;

double areaOf(const Receivers& r) {
  return std::accumulate(r.areas.begin(), r.areas.end(), 0.0);
}

TEST(VertexReceivers, ASolidBoxHasThreeOutsidePerCorner) {
  const auto surfaces =
      Builder().add(geometry::makeBox({0, 0, 0}, {1, 2, 3}), matte(vec3(0.5F))).surfaces();
  const VertexReceivers set(surfaces);
  const Receivers& r = set.receivers();
  ASSERT_EQ(r.size(), 24U);
  EXPECT_NEAR(areaOf(r), 2 * (2 + 3 + 6), 1e-5);
  for (std::size_t i = 0; i < r.size(); ++i) {
    EXPECT_GT(glm::dot(r.facing[i], r.positions[i] - vec3(0.5F, 1, 1.5F)), 0.0F);
    EXPECT_EQ(r.normals[i], r.facing[i]);
  }
}

TEST(VertexReceivers, ARoomIsSeenFromItsInside) {
  const auto box = geometry::makeBox({0, 0, 0}, {1, 2, 3});
  const auto surfaces = Builder().add(box, matte(vec3(0.5F))).surfaces({vec3(0.5F, 0.5F, 0.5F)});
  const Receivers r = VertexReceivers(surfaces).receivers();
  for (std::size_t i = 0; i < r.size(); ++i) {
    EXPECT_LT(glm::dot(r.facing[i], r.positions[i] - vec3(0.5F, 1, 1.5F)), 0.0F);
  }
}

TEST(VertexReceivers, ASmoothSphereHasOnePerPlace) {
  const auto surfaces =
      Builder().add(geometry::makeSphere({1, 2, 3}, 0.5F, 8), matte(vec3(0.5F))).surfaces();
  const Receivers r = VertexReceivers(surfaces).receivers();
  EXPECT_EQ(r.size(), 16U * 7U + 2U);
  for (std::size_t i = 0; i < r.size(); ++i) {
    // Inside of the surface no vertex is moved: the mean of its triangles is beneath it.
    EXPECT_NEAR(glm::length(r.positions[i] - vec3(1, 2, 3)), 0.5F, 2e-3F);
    EXPECT_GT(glm::dot(r.facing[i], r.normals[i]), 0.98F);
  }
}

TEST(VertexReceivers, ASheetReceivesOnBothSides) {
  const auto surfaces =
      Builder().add(geometry::makeRectangle(2, 1), matte({0.2F, 0.4F, 0.6F})).surfaces();
  const VertexReceivers set(surfaces);
  ASSERT_EQ(set.receivers().size(), 8U);
  EXPECT_NEAR(areaOf(set.receivers()), 4.0, 1e-6);
  for (int k = 0; k < 3; ++k) {
    const Receivers& r = set.receivers();
    EXPECT_EQ(r.normals[set.of(0, k, true)], vec3(0, 0, 1));
    EXPECT_EQ(r.normals[set.of(0, k, false)], vec3(0, 0, -1));
    EXPECT_EQ(r.reflectance[set.of(0, k, false)], vec3(0.2F, 0.4F, 0.6F));
  }
}

TEST(VertexReceivers, BordersAreDrawnInwardByAMillimeter) {
  const auto surfaces =
      Builder().add(geometry::makeRectangle(2, 2, 4, 4), matte(vec3(0.5F))).surfaces();
  const Receivers r = VertexReceivers(surfaces).receivers();
  for (const vec3& p : r.positions) {
    const float edge = std::max(std::abs(p.x), std::abs(p.y));
    const bool inner = edge < 0.6F;
    EXPECT_LT(edge, inner ? 0.6F : 1.0F);
    EXPECT_GT(edge, inner ? -1.0F : 0.99899F);
    EXPECT_EQ(p.z, 0.0F);
  }
}

TEST(VertexReceivers, HitsAreInterpolatedInTheTriangle) {
  const auto surfaces = Builder().add(geometry::makeRectangle(2, 2), matte(vec3(0.5F))).surfaces();
  const VertexReceivers set(surfaces);
  ReceiverSet::Around taps;
  ASSERT_EQ(set.around({1, 1.0F, 0.25F, 0.5F}, true, taps), 3U);
  EXPECT_EQ(taps[0].receiver, set.of(1, 0, true));
  EXPECT_FLOAT_EQ(taps[0].weight, 0.25F);
  EXPECT_FLOAT_EQ(taps[1].weight, 0.25F);
  EXPECT_FLOAT_EQ(taps[2].weight, 0.5F);
}

TEST(VertexReceivers, TheInsideOfASolidGivesNothing) {
  const auto surfaces =
      Builder().add(geometry::makeBox({0, 0, 0}, {1, 1, 1}), matte(vec3(0.5F))).surfaces();
  ReceiverSet::Around taps;
  EXPECT_EQ(VertexReceivers(surfaces).around({0, 1.0F, 0.2F, 0.2F}, false, taps), 0U);
}

TEST(VertexReceivers, WhatLiesInMatterTakesItsNeighborsLight) {
  // The middle of the floor is inside a block that cuts into it.
  Builder b;
  b.add(geometry::makeRectangle(4, 4, 8, 8), matte(vec3(0.5F)));
  b.add(geometry::makeBox({-0.7F, -0.7F, -0.5F}, {0.7F, 0.7F, 1.0F}), matte(vec3(0.5F)));
  const auto surfaces = b.surfaces();
  VertexReceivers set(surfaces);
  const auto valid = findUncovered(*surfaces, set.receivers()).value();
  set.replaceInvalid(valid);
  int replaced = 0;
  for (std::size_t i = 0; i < valid.size(); ++i) {
    const vec3& p = set.receivers().positions[i];
    const bool within = std::abs(p.z) < 0.1F && std::max(std::abs(p.x), std::abs(p.y)) < 0.7F;
    EXPECT_EQ(valid[i] == 0, within) << p.x << " " << p.y << " " << p.z;
    if (!within) {
      EXPECT_EQ(set.receivers().sourceOf(i), i);
      continue;
    }
    ++replaced;
    const std::uint32_t from = set.receivers().sourceOf(i);
    EXPECT_EQ(valid[from], 1);
    EXPECT_EQ(set.receivers().facing[from], set.receivers().facing[i]);
    EXPECT_LT(glm::distance(set.receivers().positions[from], p), 1.8F);
  }
  EXPECT_EQ(replaced, 2 * 9);  // both sides of the sheet
}

TEST(VertexReceivers, TrianglesWithoutAreaAndEmptyScenesAreHarmless) {
  EXPECT_EQ(VertexReceivers(Builder().surfaces()).receivers().size(), 0U);
  Builder b;
  geometry::Mesh line = testing::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  line.triangles.push_back({0, 1, 1});
  b.add(line, matte(vec3(0.5F)));
  const VertexReceivers set(b.surfaces());
  EXPECT_EQ(set.receivers().size(), 8U);
  for (const vec3& n : set.receivers().normals) EXPECT_NEAR(glm::length(n), 1.0F, 1e-6F);
}

}  // namespace
}  // namespace soffit::prt

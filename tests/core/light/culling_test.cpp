// SPDX-License-Identifier: MIT
// Shafts, the kernel that culls 16 at a time and the tree on top, against plain loops.
#include "core/light/box_tree.h"
#include "core/light/cull_kernel.h"
#include "core/light/shaft.h"

#include "core/math/rng.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

namespace soffit::light {
namespace {

vec3 randomPoint(Rng& rng, float size) {
  return size * vec3(rng.uniform(), rng.uniform(), rng.uniform());
}

Box boxAround(const vec3& p, const vec3& half) {
  Box box;
  box.add(p - half);
  box.add(p + half);
  return box;
}

Box randomBox(Rng& rng, float size) {
  return boxAround(randomPoint(rng, 10.0F), randomPoint(rng, size));
}

vec3 randomIn(Rng& rng, const Box& box) {
  return box.lo + vec3(rng.uniform(), rng.uniform(), rng.uniform()) * box.size();
}

TEST(Shaft, NothingThatMeetsASegmentBetweenTheBoxesIsOutside) {
  Rng rng(1);
  int crossing = 0;
  for (int i = 0; i < 400; ++i) {
    const Box from = randomBox(rng, 1.0F);
    const Box to = randomBox(rng, 1.0F);
    const Shaft shaft(from, to);
    EXPECT_LE(shaft.planes().size(), static_cast<std::size_t>(Shaft::kMaxPlanes));
    for (int k = 0; k < 20; ++k) {
      // A small box about a point of a segment: certainly in the way.
      const vec3 p = glm::mix(randomIn(rng, from), randomIn(rng, to), 0.05F + 0.9F * rng.uniform());
      const Box blocker = boxAround(p, vec3(0.01F));
      EXPECT_TRUE(shaft.touches(blocker));
      const std::array<vec3, 3> triangle = {p + vec3(0.01F, 0, 0), p - vec3(0.01F, 0.005F, 0),
                                            p + vec3(-0.001F, 0.01F, 0.005F)};
      EXPECT_TRUE(shaft.touches(triangle));
      ++crossing;
    }
  }
  EXPECT_EQ(crossing, 8000);
}

TEST(Shaft, LeavesOutMostOfWhatLiesBeside) {
  Rng rng(2);
  const Shaft shaft(boxAround({0, 0, 0}, vec3(0.5F)), boxAround({10, 10, 10}, vec3(0.5F)));
  int kept = 0;
  int beside = 0;
  for (int i = 0; i < 2000; ++i) {
    const vec3 p = randomPoint(rng, 10.0F);
    const vec3 axis = glm::normalize(vec3(1));
    if (glm::length(p - glm::dot(p, axis) * axis) < 2.0F) continue;
    ++beside;
    kept += shaft.touches(boxAround(p, vec3(0.1F))) ? 1 : 0;
  }
  // The hull of two equal boxes is a prism of radius 0.87; 2 is well outside.
  EXPECT_GT(beside, 500);
  EXPECT_EQ(kept, 0);
}

TEST(Shaft, WhatOnlyTouchesAPlaneIsOutside) {
  // The walls of an empty room never block between its surfaces.
  Shaft shaft(boxAround({1, 1, 0}, {1, 1, 0}), boxAround({1, 1, 3}, {0.5F, 0.5F, 0}));
  EXPECT_FALSE(shaft.touches(boxAround({0, 1, 1.5F}, {0, 1, 1.5F})));
  EXPECT_FALSE(shaft.touches(boxAround({1, 1, 3}, {2, 2, 0})));
  EXPECT_TRUE(shaft.touches(boxAround({1, 1, 1.5F}, {0.1F, 0.1F, 0})));
  shaft.addPlane({0, 0, 1}, 1.0F);
  EXPECT_FALSE(shaft.touches(boxAround({1, 1, 1.5F}, {0.1F, 0.1F, 0})));
}

/// All of the corners n.x >= w for a plane, in double precision; nothing within a rounding of it.
bool outside(std::span<const vec3> corners, const vec4& plane, bool& close) {
  double least = 1e300;
  for (const vec3& c : corners) least = std::min(least, glm::dot(dvec3(plane), dvec3(c)));
  close = close || std::abs(least - static_cast<double>(plane.w)) < 1e-5;
  return least >= static_cast<double>(plane.w);
}

std::vector<vec4> randomPlanes(Rng& rng, int count) {
  std::vector<vec4> planes;
  for (int i = 0; i < count; ++i) {
    const vec3 n = glm::normalize(randomPoint(rng, 2.0F) - vec3(1.0F));
    planes.emplace_back(n, glm::dot(n, randomPoint(rng, 10.0F)) + 2.0F);
  }
  return planes;
}

TEST(CullBoxes, AgreesWithAPlainLoop) {
  Rng rng(3);
  int kept = 0;
  for (int i = 0; i < 300; ++i) {
    BoxBlock block;
    std::vector<Box> boxes;
    const int count = 1 + i % 16;
    for (int k = 0; k < count; ++k) {
      boxes.push_back(randomBox(rng, 0.5F));
      block.set(static_cast<std::size_t>(k), boxes.back());
    }
    const auto planes = randomPlanes(rng, i % 7);
    const std::uint32_t bits = cullBoxes(block, planes);
    EXPECT_EQ(bits >> count, 0U);  // lanes that were not set
    for (int k = 0; k < count; ++k) {
      std::array<vec3, 8> corners;
      for (std::size_t c = 0; c < 8; ++c) {
        const Box& b = boxes[static_cast<std::size_t>(k)];
        corners[c] = {c & 1U ? b.hi.x : b.lo.x, c & 2U ? b.hi.y : b.lo.y, c & 4U ? b.hi.z : b.lo.z};
      }
      bool close = false;
      bool gone = false;
      for (const vec4& plane : planes) gone = outside(corners, plane, close) || gone;
      if (!close) {
        EXPECT_EQ((bits >> k & 1U) == 0U, gone);
      }
      kept += gone ? 0 : 1;
    }
  }
  EXPECT_GT(kept, 300);
}

/// Heights of a box's corners over a blocker's plane: the least and the highest.
std::pair<double, double> heights(const MaskBlocker& b, const Box& box) {
  double least = 1e300;
  double most = -1e300;
  for (std::size_t c = 0; c < 8; ++c) {
    const dvec3 corner(c & 1U ? box.hi.x : box.lo.x, c & 2U ? box.hi.y : box.lo.y,
                       c & 4U ? box.hi.z : box.lo.z);
    const double h = glm::dot(dvec3(b.normal), corner) - static_cast<double>(b.d);
    least = std::min(least, h);
    most = std::max(most, h);
  }
  return {least, most};
}

TEST(Filter, AgreesWithAPlainLoop) {
  Rng rng(4);
  std::size_t kept = 0;
  std::size_t cut_count = 0;
  for (int i = 0; i < 600; ++i) {
    BlockerLanes in;
    const std::size_t size = 1 + static_cast<std::size_t>(i) % 40;
    for (std::size_t k = 0; k < size; ++k) {
      MaskBlocker b;
      const vec3 p = randomPoint(rng, 10.0F);
      for (int c = 0; c < 3; ++c)
        b.corners[static_cast<std::size_t>(c)] = p + randomPoint(rng, 2.0F);
      b.normal =
          glm::normalize(glm::cross(b.corners[1] - b.corners[0], b.corners[2] - b.corners[0]));
      b.d = glm::dot(b.normal, b.corners[0]);
      b.solid = k % 3 == 0;
      if (i % 2 == 0) {  // a parallelogram, or one with a corner cut off
        b.corners[3] = b.corners[0] + b.corners[2] - b.corners[1];
        b.count = 4;
        if (i % 4 == 0) {
          b.corners[4] = glm::mix(b.corners[3], b.corners[0], 0.6F);
          b.corners[3] = glm::mix(b.corners[3], b.corners[2], 0.6F);
          b.count = 5;
        }
      }
      in.push(b);
    }
    const auto planes = randomPlanes(rng, i % 4);
    const vec4 cut = randomPlanes(rng, 1)[0];
    BlockerFilter filter{boxAround(vec3(5), vec3(4)), planes, randomBox(rng, 1.0F),
                         randomBox(rng, 1.0F), i % 5 == 0 ? nullptr : &cut};
    BlockerLanes out;
    std::vector<std::size_t> behind_found;
    for (std::size_t first = 0; first < size; first += BlockerLanes::kBlock) {
      const std::uint32_t bits = filterLanes(in, first, filter, out);
      for (std::size_t k = 0; k < 32; ++k) {
        if ((bits >> k & 1U) != 0U) behind_found.push_back(first + k);
      }
    }
    std::vector<vec3> expected;
    std::vector<std::size_t> behind_expected;
    bool any_close = false;
    for (std::size_t k = 0; k < size; ++k) {
      const MaskBlocker b = in.at(k);
      const std::span corners(b.corners.data(), static_cast<std::size_t>(b.count));
      bool close = false;
      bool gone = false;
      for (const vec4& plane : planes) gone = outside(corners, plane, close) || gone;
      for (int axis = 0; axis < 3; ++axis) {
        vec4 side(0.0F);
        side[axis] = 1.0F;
        side.w = filter.hull.hi[axis];
        gone = outside(corners, side, close) || gone;
        side[axis] = -1.0F;
        side.w = -filter.hull.lo[axis];
        gone = outside(corners, side, close) || gone;
      }
      const auto [receivers_lo, receivers_hi] = heights(b, filter.receivers);
      const auto [light_lo, light_hi] = heights(b, filter.light);
      const bool front = receivers_hi > 0 && light_lo < 0;
      const bool back = receivers_lo < 0 && light_hi > 0;
      gone = gone || !(front || (back && !b.solid));
      for (const double h : {receivers_lo, receivers_hi, light_lo, light_hi}) {
        close = close || std::abs(h) < 1e-5;
      }
      bool behind = false;
      double least = 1e300;
      for (const vec3& c : corners) least = std::min(least, glm::dot(dvec3(cut), dvec3(c)));
      behind = filter.cut != nullptr && least <= static_cast<double>(cut.w);
      close = close || std::abs(least - static_cast<double>(cut.w)) < 1e-5;
      any_close = any_close || close;
      if (gone) continue;
      if (behind) behind_expected.push_back(k);
      if (!behind) expected.push_back(b.corners[0]);
    }
    if (any_close) continue;
    std::vector<vec3> found;
    for (std::size_t k = 0; k < out.size(); ++k) found.push_back(out.at(k).corners[0]);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(behind_found, behind_expected);
    kept += found.size();
    cut_count += behind_found.size();
  }
  EXPECT_GT(kept, 100U);
  EXPECT_GT(cut_count, 100U);
}

TEST(OrderByPlace, IsAPermutationIntoCompactRuns) {
  Rng rng(5);
  std::vector<vec3> points(1000);
  for (vec3& p : points) p = randomPoint(rng, 10.0F);
  const std::vector<std::uint32_t> order = orderByPlace(points);
  std::vector<std::uint32_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(sorted, all);
  double volume = 0.0;
  for (std::size_t i = 0; i + 16 <= points.size(); i += 16) {
    Box box;
    for (std::size_t k = i; k < i + 16; ++k) box.add(points[order[k]]);
    volume += static_cast<double>(box.size().x) * static_cast<double>(box.size().y) *
              static_cast<double>(box.size().z);
  }
  EXPECT_LT(volume, 1000.0);  // runs hardly overlap: together no more than the cube they fill
}

TEST(BoxTree, FindsWhatAPlainLoopFinds) {
  Rng rng(6);
  for (const std::size_t count : {0U, 1U, 15U, 16U, 17U, 300U, 5000U}) {
    std::vector<vec3> centers(count);
    for (vec3& p : centers) p = randomPoint(rng, 10.0F);
    const std::vector<std::uint32_t> order = orderByPlace(centers);
    std::vector<Box> boxes;
    for (const std::uint32_t i : order)
      boxes.push_back(boxAround(centers[i], randomPoint(rng, 0.2F)));
    const BoxTree tree(boxes);
    for (int k = 0; k < 20; ++k) {
      const Box from = randomBox(rng, 1.0F);
      const Shaft shaft(from, randomBox(rng, 0.5F));
      std::vector<BoxTree::Part> parts;
      tree.collect(shaft, parts);
      std::set<std::size_t> found;
      for (const BoxTree::Part& part : parts) {
        for (int bit = 0; bit < 16; ++bit) {
          if ((part.bits >> bit & 1U) == 0U) continue;
          EXPECT_TRUE(found.insert(part.index(bit)).second);
        }
      }
      std::set<std::size_t> expected;
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (shaft.touches(boxes[i])) expected.insert(i);
      }
      // "Not certainly outside": the kernel rounds in its own order, so one more or less at a
      // plane.
      std::vector<std::size_t> different;
      std::set_symmetric_difference(found.begin(), found.end(), expected.begin(), expected.end(),
                                    std::back_inserter(different));
      EXPECT_LE(different.size(), count / 1000);
      // A narrower shaft within the wide one: refining its parts finds the same.
      const Shaft narrow(boxAround(from.center(), 0.1F * from.size()),
                         boxAround(from.center() + vec3(1), vec3(0.1F)));
      for (const BoxTree::Part& part : parts) EXPECT_EQ(tree.refine(part, narrow) & ~part.bits, 0U);
    }
  }
}

}  // namespace
}  // namespace soffit::light

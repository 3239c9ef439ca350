// SPDX-License-Identifier: MIT
#include "core/geometry/components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/cleaning.h"
#include "core/geometry/shapes.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"

namespace soffit::geometry {
namespace {

// Every triangle gets vertices of its own, and a new place in the list.
Mesh shuffledSoup(const Mesh& mesh, std::uint64_t seed) {
  Mesh soup = mesh;
  soup.positions.clear();
  soup.normals.clear();
  Rng rng(seed);
  for (std::size_t i = soup.triangles.size(); i > 1; --i) {
    std::swap(soup.triangles[i - 1], soup.triangles[rng.below(static_cast<unsigned>(i))]);
  }
  for (uvec3& t : soup.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (int k = 0; k < 3; ++k) soup.positions.push_back(mesh.positions[t[k]]);
    t = {first, first + 1, first + 2};
  }
  return soup;
}

Mesh transformed(Mesh mesh, const dvec3& rotation_deg, const dvec3& shift) {
  const dmat3 turn = rotationXyz(rotation_deg);
  for (vec3& p : mesh.positions) p = vec3(turn * dvec3(p) + shift);
  return mesh;
}

TEST(Components, FindsEveryPieceOfASoup) {
  const Mesh all =
      mergeMeshes({makeBox({0, 0, 0}, {1, 1, 1}), makeSphere({4, 0, 0}, 1, 8), makeDisk(1.0F, 9)});
  const Components parts = findComponents(shuffledSoup(all, 5));
  ASSERT_EQ(parts.list.size(), 3U);
  std::size_t total = 0;
  int solids = 0;
  for (std::size_t c = 0; c < parts.list.size(); ++c) {
    total += parts.list[c].triangles.size();
    if (parts.list[c].solid()) ++solids;
    for (const std::uint32_t t : parts.list[c].triangles) EXPECT_EQ(parts.component_of[t], c);
  }
  EXPECT_EQ(total, all.triangles.size());
  EXPECT_EQ(solids, 2);
}

TEST(Components, WeldsFacesThatRoundingHasMovedApart) {
  // The six faces of a box, each through a transform of its own and back, differ by rounding.
  Mesh box = makeBox({3, 4, 5}, {4, 6, 8});
  Rng rng(7);
  for (vec3& p : box.positions) {
    for (int k = 0; k < 3; ++k) {
      const float r = rng.uniform();
      p[k] = r < 0.3F ? std::nextafter(p[k], 0.0F) : r > 0.7F ? std::nextafter(p[k], 9.0F) : p[k];
    }
  }
  const Components parts = findComponents(box);
  ASSERT_EQ(parts.list.size(), 1U);
  EXPECT_TRUE(parts.list[0].solid());
  // Round-off: corners moved by 2^-21 m, times the box's area of 22 m2.
  EXPECT_NEAR(parts.list[0].signed_volume, 6.0, 22 * 0x1p-20);
}

TEST(Components, SaysWhetherClosed) {
  Mesh box = makeBox({0, 0, 0}, {1, 1, 1});
  box.triangles.pop_back();
  const Components parts = findComponents(box);
  ASSERT_EQ(parts.list.size(), 1U);
  EXPECT_FALSE(parts.list[0].closed);
  EXPECT_TRUE(parts.list[0].consistent);
}

TEST(Components, SaysWhetherConsistentlyWound) {
  Mesh box = makeBox({0, 0, 0}, {1, 1, 1});
  std::swap(box.triangles[3].x, box.triangles[3].y);
  const Components parts = findComponents(box);
  ASSERT_EQ(parts.list.size(), 1U);
  EXPECT_TRUE(parts.list[0].closed);
  EXPECT_FALSE(parts.list[0].consistent);
}

TEST(Components, InwardWindingHasNegativeVolume) {
  Mesh box = makeBox({0, 0, 0}, {1, 2, 3});
  for (uvec3& t : box.triangles) std::swap(t.x, t.y);
  const Components parts = findComponents(box);
  EXPECT_TRUE(parts.list[0].solid());
  EXPECT_FALSE(parts.list[0].outward());
  EXPECT_NEAR(parts.list[0].signed_volume, -6.0, 6 * 64 * 0x1p-24);
}

TEST(Components, BoxesThatTouchAtAnEdgeOrAFaceStayApart) {
  const Mesh first = makeBox({0, 0, 0}, {1, 1, 1});
  for (const vec3 at : {vec3(1, 1, 0), vec3(1, 0, 0), vec3(0, 0, 1)}) {
    for (const dvec3 turn : {dvec3(0.0), dvec3(20.0, 50.0, 70.0)}) {
      const Mesh both =
          transformed(mergeMeshes({first, makeBox(at, at + vec3(1))}), turn, {0.1, 0.2, 0.3});
      const Components parts = findComponents(shuffledSoup(both, 11));
      ASSERT_EQ(parts.list.size(), 2U) << at.x << at.y << at.z;
      for (const Component& part : parts.list) {
        EXPECT_TRUE(part.solid());
        EXPECT_EQ(part.triangles.size(), 12U);
        EXPECT_NEAR(part.signed_volume, 1.0, 256 * 0x1p-24);  // round-off of turned corners
      }
    }
  }
}

TEST(Components, ASheetAgainstABoxLeavesTheBoxClosed) {
  // A partition that ends at the vertical edge of a cabinet, with the edge's end points in common.
  Mesh sheet = makeRectangle(1.0F, 1.0F);
  for (vec3& p : sheet.positions) p = {1.5F + p.x, 1.0F, 0.5F + p.y};
  const Components parts = findComponents(mergeMeshes({makeBox({0, 0, 0}, {1, 1, 1}), sheet}));
  ASSERT_EQ(parts.list.size(), 2U);
  EXPECT_TRUE(parts.list[0].solid());
  EXPECT_FALSE(parts.list[1].closed);
  EXPECT_EQ(parts.list[1].triangles.size(), 2U);
}

TEST(Components, TrianglesWithoutAreaAreOpenPartsOfTheirOwn) {
  Mesh box = makeBox({0, 0, 0}, {1, 1, 1});
  box.triangles.emplace_back(0U, 0U, 1U);
  box.material_of.push_back(0);
  box.object_of.push_back(0);
  const Components parts = findComponents(box);
  ASSERT_EQ(parts.list.size(), 2U);
  EXPECT_TRUE(parts.list[0].solid());
  EXPECT_FALSE(parts.list[1].closed);
}

TEST(Components, NothingHasNoComponents) {
  EXPECT_TRUE(findComponents(Mesh{}).list.empty());
}

TEST(Contains, AgreesWithTheSphereItApproximates) {
  const Mesh sphere = makeSphere({2, 1, 0}, 1.5F, 24);
  const Components parts = findComponents(sphere);
  Rng rng(3);
  for (int i = 0; i < 2000; ++i) {
    const float r = 3.0F * rng.uniform();
    if (std::abs(r - 1.5F) < 0.02F) continue;  // truncation: the facets lie up to 1 % inside
    const vec3 p = vec3(2, 1, 0) + r * uniformSphere(rng.uniform(), rng.uniform());
    ASSERT_EQ(contains(sphere, parts.list[0], p), r < 1.5F) << r;
  }
}

TEST(Contains, HoldsOnRaysThatWouldMeetVerticesAndForEitherWinding) {
  Mesh box = makeBox({0, 0, 0}, {2, 2, 2});
  for (int winding = 0; winding < 2; ++winding) {
    const Components parts = findComponents(box);
    for (const float x : {0.0F, 0.5F, 1.0F, 1.5F, 2.0F}) {
      const vec3 p(0.5F + 0.5F * x, 1.0F, 1.0F);
      EXPECT_TRUE(contains(box, parts.list[0], {1.0F, p.x, 1.0F}));
      EXPECT_FALSE(contains(box, parts.list[0], {3.0F, x, x}));
      EXPECT_FALSE(contains(box, parts.list[0], {x, -0.001F, x}));
    }
    for (uvec3& t : box.triangles) std::swap(t.x, t.y);
  }
}

TEST(Contains, APointInTheBoundsMayBeOutside) {
  const Mesh tube = makeTube(2.0F, 1.0F, 16, true);
  const Components parts = findComponents(tube);
  EXPECT_FALSE(contains(tube, parts.list[0], {0.5F, 0.9F, 0.9F}));
  EXPECT_TRUE(contains(tube, parts.list[0], {0.5F, 0.6F, 0.6F}));
}

}  // namespace
}  // namespace soffit::geometry

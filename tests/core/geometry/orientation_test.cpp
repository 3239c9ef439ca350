// SPDX-License-Identifier: MIT
#include "core/geometry/orientation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/cleaning.h"
#include "core/geometry/components.h"
#include "core/geometry/shapes.h"
#include "core/math/rng.h"

namespace soffit::geometry {
namespace {

struct Welded {
  std::vector<vec3> points;
  std::vector<uvec3> triangles;
};

Welded weld(const Mesh& mesh) {
  const std::vector<std::uint32_t> point = findComponents(mesh).point_of;
  Welded out{mesh.positions, {}};
  for (const uvec3& t : mesh.triangles) {
    out.triangles.emplace_back(point[t.x], point[t.y], point[t.z]);
  }
  return out;
}

std::ptrdiff_t countTurned(const Welded& w) {
  const std::vector<char> turned = findTurned(w.points, w.triangles);
  return std::count(turned.begin(), turned.end(), char{1});
}

TEST(Orientation, ATwistedSolidGetsItsFrontsOutward) {
  Welded sphere = weld(makeSphere({0, 0, 0}, 1, 10));
  Rng rng(9);
  std::vector<char> expected;
  for (uvec3& t : sphere.triangles) {  // most of them inward
    expected.push_back(rng.uniform() < 0.8F ? 1 : 0);
    if (expected.back() != 0) std::swap(t.x, t.y);
  }
  EXPECT_EQ(findTurned(sphere.points, sphere.triangles), expected);
}

TEST(Orientation, ConsistentPartsStayAsTheyAre) {
  Welded box = weld(makeBox({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(countTurned(box), 0);
  for (uvec3& t : box.triangles) std::swap(t.x, t.y);  // inside out, on purpose
  EXPECT_EQ(countTurned(box), 0);
}

TEST(Orientation, AnOpenPartFacesAsMostOfItsAreaDoes) {
  Welded grid = weld(makeRectangle(3, 1, 3, 1));
  std::swap(grid.triangles[0].x, grid.triangles[0].y);
  EXPECT_EQ(findTurned(grid.points, grid.triangles), (std::vector<char>{1, 0, 0, 0, 0, 0}));
  for (uvec3& t : grid.triangles) std::swap(t.x, t.y);
  EXPECT_EQ(findTurned(grid.points, grid.triangles), (std::vector<char>{1, 0, 0, 0, 0, 0}));
}

TEST(Orientation, AMoebiusBandIsLeftAlone) {
  Welded band;
  constexpr std::uint32_t kSteps = 20;
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const double phi = 2.0 * kPi * i / kSteps;
    for (const double side : {-0.3, 0.3}) {
      const double r = 1.0 + side * std::cos(0.5 * phi);
      band.points.emplace_back(r * std::cos(phi), r * std::sin(phi), side * std::sin(0.5 * phi));
    }
  }
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const std::uint32_t a = 2 * i;
    const bool last = i + 1 == kSteps;
    const std::uint32_t c = last ? 1 : a + 2;  // half a turn: the edges change places
    const std::uint32_t d = last ? 0 : a + 3;
    band.triangles.emplace_back(a, a + 1, c);
    band.triangles.emplace_back(a + 1, d, c);
  }
  EXPECT_EQ(countTurned(band), 0);
}

TEST(Orientation, CleaningTurnsTrianglesWithTheirVertices) {
  Mesh box = makeBox({0, 0, 0}, {1, 2, 3});
  RawMesh raw;
  for (std::size_t i = 0; i < box.triangles.size(); ++i) {
    uvec3 t = box.triangles[i];
    if (i % 3 == 0) std::swap(t.x, t.z);
    const auto first = static_cast<std::uint32_t>(raw.positions.size());
    for (int k = 0; k < 3; ++k) {
      const vec3 p = box.positions[t[k]];
      raw.positions.emplace_back(p);
      raw.normals.push_back(box.normals[t[k]]);
      raw.uvs.emplace_back(p.x + 10.0F * p.z, p.y);  // tells the corner
    }
    raw.triangles.emplace_back(first, first + 1, first + 2);
  }
  raw.material_of = box.material_of;
  raw.object_of = box.object_of;
  const CleanedMesh cleaned = cleanMesh(raw);
  EXPECT_EQ(cleaned.report.turned, 4U);
  const Components parts = findComponents(cleaned.mesh);
  EXPECT_TRUE(parts.list.at(0).solid());
  EXPECT_TRUE(parts.list.at(0).outward());
  for (const uvec3& t : cleaned.mesh.triangles) {
    const vec3 a = cleaned.mesh.positions[t.x];
    const vec3 face = glm::cross(cleaned.mesh.positions[t.y] - a, cleaned.mesh.positions[t.z] - a);
    for (int k = 0; k < 3; ++k) {
      const vec3 p = cleaned.mesh.positions[t[k]];
      EXPECT_EQ(cleaned.mesh.uvs[t[k]], vec2(p.x + 10.0F * p.z, p.y));
      EXPECT_GT(glm::dot(cleaned.mesh.normals[t[k]], face), 0.0F);
    }
  }
}

TEST(Orientation, NormalsAgainstTheWindingAreNegated) {
  RawMesh raw;
  raw.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  raw.normals.assign(3, {0, 0, -1});
  raw.triangles = {{0, 1, 2}};
  raw.material_of = {0};
  raw.object_of = {0};
  for (const vec3& n : cleanMesh(raw).mesh.normals) EXPECT_EQ(n, vec3(0, 0, 1));
}

}  // namespace
}  // namespace soffit::geometry

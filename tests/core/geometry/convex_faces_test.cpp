// SPDX-License-Identifier: MIT
#include "core/geometry/convex_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/cleaning.h"
#include "core/geometry/shapes.h"

namespace soffit::geometry {
namespace {

double triangleArea(const dvec3& a, const dvec3& b, const dvec3& c) {
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

double area(const ConvexFace& face) {
  double sum = 0.0;
  for (std::size_t k = 2; k < static_cast<std::size_t>(face.count); ++k) {
    sum += triangleArea(dvec3(face.corners[0]), dvec3(face.corners[k - 1]), dvec3(face.corners[k]));
  }
  return sum;
}

double area(const Mesh& mesh, std::size_t t) {
  const uvec3 v = mesh.triangles[t];
  return triangleArea(dvec3(mesh.positions[v.x]), dvec3(mesh.positions[v.y]),
                      dvec3(mesh.positions[v.z]));
}

dvec3 normal(const ConvexFace& face) {
  return glm::normalize(glm::cross(dvec3(face.corners[1] - face.corners[0]),
                                   dvec3(face.corners[2] - face.corners[0])));
}

// A point in the plane of a face lies in it: left of every edge, with slack in metres.
bool covers(const ConvexFace& face, const dvec3& p, double slack) {
  for (int k = 0; k < face.count; ++k) {
    const dvec3 a(face.corners[static_cast<std::size_t>(k)]);
    const dvec3 b(face.corners[static_cast<std::size_t>((k + 1) % face.count)]);
    const dvec3 inward = glm::cross(normal(face), glm::normalize(b - a));
    if (glm::dot(p - a, inward) < -slack) return false;
  }
  return std::abs(glm::dot(p - dvec3(face.corners[0]), normal(face))) <= slack;
}

// Each face covers its triangles and has their area: together that is the same point set, once.
void expectSameCover(const Mesh& mesh, const ConvexFaces& merged) {
  ASSERT_EQ(merged.face_of.size(), mesh.triangles.size());
  std::vector<double> sum(merged.faces.size(), 0.0);
  std::vector<std::uint32_t> count(merged.faces.size(), 0);
  const double slack = 1e-6 * double{mesh.bounds().diagonal()};  // as documented
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t f = merged.face_of[t];
    sum[f] += area(mesh, t);
    ++count[f];
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(covers(merged.faces[f], dvec3(mesh.positions[mesh.triangles[t][k]]), slack));
    }
    EXPECT_EQ(merged.faces[f].material, mesh.material_of[t]);
  }
  for (std::size_t f = 0; f < merged.faces.size(); ++f) {
    EXPECT_EQ(merged.faces[f].triangles, count[f]);
    // Round-off and slack: the border's length times the slack.
    EXPECT_NEAR(area(merged.faces[f]), sum[f], 4 * slack * mesh.bounds().diagonal());
  }
}

ConvexFaces merge(const Mesh& mesh) {
  return mergeConvexFaces(mesh, findComponents(mesh));
}

Mesh turned(Mesh mesh) {
  const dmat3 turn = rotationXyz({33.0, 21.0, -57.0});
  for (vec3& p : mesh.positions) p = vec3(turn * dvec3(p) + dvec3(3.0, -2.0, 1.0));
  return mesh;
}

TEST(ConvexFaces, ABoxHasSix) {
  for (const Mesh& box : {makeBox({0, 0, 0}, {1, 2, 3}), turned(makeBox({0, 0, 0}, {1, 2, 3}))}) {
    const ConvexFaces merged = merge(box);
    ASSERT_EQ(merged.faces.size(), 6U);
    for (const ConvexFace& face : merged.faces) EXPECT_EQ(face.count, 4);
    expectSameCover(box, merged);
  }
}

TEST(ConvexFaces, AGridBecomesOneRectangle) {
  for (const Mesh& grid : {makeRectangle(12, 8, 24, 16), turned(makeRectangle(12, 8, 24, 16))}) {
    const ConvexFaces merged = merge(grid);
    ASSERT_EQ(merged.faces.size(), 1U);
    EXPECT_EQ(merged.faces[0].count, 4);
    EXPECT_EQ(merged.faces[0].triangles, 768U);
    expectSameCover(grid, merged);
  }
}

TEST(ConvexFaces, FrontsStayFronts) {
  const ConvexFaces merged = merge(makeRectangle(2, 1, 3, 2));
  ASSERT_EQ(merged.faces.size(), 1U);
  EXPECT_NEAR(normal(merged.faces[0]).z, 1.0, 8 * 0x1p-24);  // round-off
}

TEST(ConvexFaces, MaterialsStayApart) {
  Mesh grid = makeRectangle(2, 1, 2, 1);
  grid.materials = {"left", "right"};
  grid.material_of = {0, 0, 1, 1};
  const ConvexFaces merged = merge(grid);
  ASSERT_EQ(merged.faces.size(), 2U);
  expectSameCover(grid, merged);
}

TEST(ConvexFaces, AReflexCornerIsNotFilled) {
  // An L of three unit squares: at best two rectangles.
  Mesh grid = makeRectangle(2, 2, 2, 2);
  grid.triangles.resize(6);
  grid.material_of.resize(6);
  grid.object_of.resize(6);
  const ConvexFaces merged = merge(grid);
  EXPECT_EQ(merged.faces.size(), 2U);
  expectSameCover(grid, merged);
}

TEST(ConvexFaces, AFoldedSheetKeepsItsFold) {
  Mesh sheet = makeRectangle(2, 2, 2, 1);
  for (vec3& p : sheet.positions) p.z = 1e-3F * std::abs(p.x);
  const ConvexFaces merged = merge(sheet);
  EXPECT_EQ(merged.faces.size(), 2U);
  expectSameCover(sheet, merged);
}

TEST(ConvexFaces, AFanOfSixtyDegreesMakesThreeRhombiOrBetter) {
  const Mesh disk = makeDisk(1.0F, 6);
  const ConvexFaces merged = merge(disk);
  EXPECT_LE(merged.faces.size(), 3U);
  expectSameCover(disk, merged);
}

TEST(ConvexFaces, CurvedSurfacesOnlyPairTheirPlanarQuads) {
  const Mesh sphere = makeSphere({0, 0, 0}, 1, 8);
  const ConvexFaces merged = merge(sphere);
  // 16 triangles at either pole; between them every latitude quad is a planar trapezoid.
  EXPECT_EQ(merged.faces.size(), 16U * 2U + 16U * 6U);
  expectSameCover(sphere, merged);
}

TEST(ConvexFaces, OppositelyWoundNeighborsStayApart) {
  Mesh quad = makeRectangle(1, 1);
  std::swap(quad.triangles[0].x, quad.triangles[0].y);
  EXPECT_EQ(merge(quad).faces.size(), 2U);
}

TEST(ConvexFaces, NothingGivesNothing) {
  EXPECT_TRUE(merge(Mesh{}).faces.empty());
}

}  // namespace
}  // namespace soffit::geometry

// SPDX-License-Identifier: MIT
#include "core/geometry/cleaning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/geometry/components.h"
#include "core/geometry/shapes.h"

namespace soffit::geometry {
namespace {

// A mesh as a file would give it: a vertex per corner, in double precision, no normals.
RawMesh soupOf(const Mesh& mesh) {
  RawMesh raw;
  for (const uvec3& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(raw.positions.size());
    for (int k = 0; k < 3; ++k) {
      raw.positions.push_back(mesh.origin + dvec3(mesh.positions[t[k]]));
    }
    raw.triangles.emplace_back(first, first + 1, first + 2);
  }
  raw.material_of = mesh.material_of;
  raw.object_of = mesh.object_of;
  raw.materials = mesh.materials;
  raw.objects = mesh.objects;
  return raw;
}

void addTriangle(RawMesh& raw, const dvec3& a, const dvec3& b, const dvec3& c) {
  const auto first = static_cast<std::uint32_t>(raw.positions.size());
  raw.positions.insert(raw.positions.end(), {a, b, c});
  raw.triangles.emplace_back(first, first + 1, first + 2);
  raw.material_of.push_back(0);
  raw.object_of.push_back(0);
}

TEST(Cleaning, WeldsASoupIntoAnIndexedMesh) {
  const CleanedMesh cleaned = cleanMesh(soupOf(makeBox({0, 0, 0}, {1, 2, 3})));
  EXPECT_EQ(cleaned.report.triangles_in, 12U);
  EXPECT_EQ(cleaned.report.triangles_out, 12U);
  EXPECT_EQ(cleaned.report.dropped(), 0U);
  EXPECT_EQ(cleaned.report.vertices_in, 36U);
  EXPECT_EQ(cleaned.report.vertices_out, 24U);  // 8 points with three hard normals each
  EXPECT_EQ(cleaned.mesh.positions.size(), 24U);
  EXPECT_TRUE(cleaned.mesh.uvs.empty());
  EXPECT_EQ(cleaned.mesh.origin, dvec3(0.0));
  EXPECT_TRUE(findComponents(cleaned.mesh).list.at(0).solid());
}

TEST(Cleaning, CountsWhatItDrops) {
  RawMesh raw = soupOf(makeBox({0, 0, 0}, {1, 1, 1}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  addTriangle(raw, {nan, 0, 0}, {1, 0, 0}, {0, 1, 0});
  addTriangle(raw, {0, 0, 0}, {inf, 0, 0}, {0, 1, 0});
  addTriangle(raw, {0, 0, 0}, {0, 0, 1e300}, {0, 1, 0});
  addTriangle(raw, {0, 0, 5}, {0, 0, 5}, {0, 1, 5});         // two corners in one point
  addTriangle(raw, {0, 0, 5}, {1, 1, 5}, {3, 3, 5});         // on a line
  addTriangle(raw, {0, 0, 5}, {1, 0, 5 + 1e-8}, {3, 0, 5});  // lower than single precision
  addTriangle(raw, {0, 0, 4}, {1, 0, 4}, {0, 1, 4});         // the one to keep
  addTriangle(raw, {1, 0, 4}, {0, 1, 4}, {0, 0, 4});         // the same, turned
  addTriangle(raw, {1, 0, 4}, {0, 0, 4}, {0, 1, 4});         // the same, from behind
  addTriangle(raw, {1, 0, 4}, {0, 0, 4}, {0, 1, 4 + 1e-9});  // the same but for rounding
  const CleanedMesh cleaned = cleanMesh(raw);
  EXPECT_EQ(cleaned.report.non_finite, 3U);
  EXPECT_EQ(cleaned.report.degenerate, 3U);
  EXPECT_EQ(cleaned.report.duplicate, 3U);
  EXPECT_EQ(cleaned.report.triangles_out, 13U);
  EXPECT_EQ(cleaned.mesh.triangles.size(), 13U);
  EXPECT_EQ(cleaned.mesh.material_of.size(), 13U);
  EXPECT_EQ(cleaned.mesh.object_of.size(), 13U);
}

TEST(Cleaning, KeepsSmallThingsInLargeModels) {
  // A millimetre cube in the corner of a site of one kilometre: a million to one.
  const Mesh site = mergeMeshes(
      {makeBox({0, 0, 0}, {1000, 1000, 100}), makeBox({1, 1, 1}, {1.001F, 1.001F, 1.001F})});
  const CleanedMesh cleaned = cleanMesh(soupOf(site));
  EXPECT_EQ(cleaned.report.dropped(), 0U);
  const Components parts = findComponents(cleaned.mesh);
  ASSERT_EQ(parts.list.size(), 2U);
  EXPECT_TRUE(parts.list[1].solid());
}

TEST(Cleaning, ScalesDoNotChangeWhatIsDropped) {
  for (const double scale : {1e-3, 1.0, 1e3, 1e6}) {
    RawMesh raw = soupOf(makeSphere({0, 0, 0}, 1, 12));
    addTriangle(raw, {0, 0, 0}, {0.5, 0.5, 0.5}, {0.25, 0.25, 0.25});
    for (dvec3& p : raw.positions) p *= scale;
    const CleanedMesh cleaned = cleanMesh(raw);
    EXPECT_EQ(cleaned.report.degenerate, 1U) << scale;
    EXPECT_EQ(cleaned.report.dropped(), 1U) << scale;
    EXPECT_TRUE(findComponents(cleaned.mesh).list.at(0).solid()) << scale;
  }
}

TEST(Cleaning, SurveyCoordinatesKeepTheirMillimetres) {
  RawMesh raw = soupOf(makeBox({0, 0, 0}, {10, 8, 3}));
  const dvec3 site(451230.125, 5812345.75, 34.5);
  for (dvec3& p : raw.positions) p += site;
  addTriangle(raw, site + dvec3(1, 1, 1), site + dvec3(1.002, 1, 1), site + dvec3(1, 1.002, 1));
  const CleanedMesh cleaned = cleanMesh(raw);
  EXPECT_EQ(cleaned.report.dropped(), 0U);
  EXPECT_EQ(cleaned.mesh.origin, glm::round(cleaned.mesh.origin));
  EXPECT_LT(cleaned.mesh.bounds().diagonal(), 14.0F);
  for (const vec3& p : cleaned.mesh.positions) {
    double nearest = 1.0;
    for (const dvec3& q : raw.positions) {
      nearest = std::min(nearest, glm::distance(cleaned.mesh.origin + dvec3(p), q));
    }
    EXPECT_LT(nearest, 16 * 0x1p-24 + 1e-9);  // round-off of 16 m, and of the sum above
  }
}

TEST(Cleaning, GivenNormalsAndTexturesKeepVerticesApart) {
  RawMesh raw;
  addTriangle(raw, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  addTriangle(raw, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  raw.materials = {"m"};
  raw.objects = {"o"};
  raw.normals.assign(6, {0, 0, 2});
  raw.uvs = {{0, 0}, {1, 0}, {0, 1}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(cleanMesh(raw).mesh.positions.size(), 4U);
  for (const vec3& n : cleanMesh(raw).mesh.normals) EXPECT_EQ(n, vec3(0, 0, 1));
  EXPECT_EQ(cleanMesh(raw).report.made_normals, 0U);
  raw.uvs[3] = {0.5F, 0};  // a seam
  EXPECT_EQ(cleanMesh(raw).mesh.positions.size(), 5U);
  raw.normals[5] = {0, 1, 1};  // a hard edge
  EXPECT_EQ(cleanMesh(raw).mesh.positions.size(), 6U);
  raw.uvs[0].x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(cleanMesh(raw).mesh.uvs[0], vec2(0, 0));
}

TEST(Cleaning, NormalsAreMadeOnlyWhereMissing) {
  RawMesh raw;
  addTriangle(raw, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  addTriangle(raw, {5, 0, 0}, {6, 0, 0}, {5, 1, 0});
  raw.materials = {"m"};
  raw.objects = {"o"};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  raw.normals = {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {nan, 0, 0}, {0, 1, 0}};
  const CleanedMesh cleaned = cleanMesh(raw);
  EXPECT_EQ(cleaned.report.made_normals, 1U);
  const std::vector<vec3> expected{{1, 0, 0}, {1, 0, 0}, {1, 0, 0},
                                   {0, 0, 1}, {0, 0, 1}, {0, 1, 0}};
  EXPECT_EQ(cleaned.mesh.normals, expected);
}

TEST(Cleaning, NothingStaysNothing) {
  const CleanedMesh cleaned = cleanMesh({});
  EXPECT_TRUE(cleaned.mesh.triangles.empty());
  EXPECT_EQ(cleaned.report.dropped(), 0U);
}

TEST(Cleaning, DoesNotDependOnTheThreadCount) {
  const RawMesh raw = soupOf(makeSphere({1, 2, 3}, 1, 60));
  setThreadCount(1);
  const Mesh one = cleanMesh(raw).mesh;
  setThreadCount(4);
  const Mesh four = cleanMesh(raw).mesh;
  setThreadCount(0);
  EXPECT_EQ(one.positions, four.positions);
  EXPECT_EQ(one.normals, four.normals);
  EXPECT_EQ(one.triangles, four.triangles);
}

}  // namespace
}  // namespace soffit::geometry

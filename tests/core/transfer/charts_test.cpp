// SPDX-License-Identifier: MIT
#include "core/transfer/charts.h"

#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::transfer {
namespace {

using namespace testing;

std::vector<std::uint8_t> bothSides(const geometry::Mesh& mesh) {
  return std::vector<std::uint8_t>(mesh.triangles.size(), kBothSides);
}

double areaOf(const geometry::Mesh& mesh, std::uint32_t t) {
  const dvec3 a(mesh.positions[mesh.triangles[t].x]);
  return 0.5 * glm::length(glm::cross(dvec3(mesh.positions[mesh.triangles[t].y]) - a,
                                      dvec3(mesh.positions[mesh.triangles[t].z]) - a));
}

/// Every triangle is in one chart, and areas add up.
void expectPartition(const geometry::Mesh& mesh, const Charts& charts) {
  std::vector<int> seen(mesh.triangles.size(), 0);
  ASSERT_EQ(charts.chart_of.size(), mesh.triangles.size());
  for (std::size_t c = 0; c < charts.charts.size(); ++c) {
    const Chart& chart = charts.charts[c];
    double area = 0.0;
    for (std::uint32_t k = 0; k < chart.triangle_count; ++k) {
      const std::uint32_t t = charts.triangles[chart.first_triangle + k];
      ++seen[t];
      EXPECT_EQ(charts.chart_of[t], c);
      EXPECT_EQ(mesh.material_of[t], chart.material);
      area += areaOf(mesh, t);
    }
    EXPECT_NEAR(chart.area, area, 1e-6 * area);  // single precision
  }
  for (const int n : seen) EXPECT_EQ(n, 1);
}

TEST(Charts, ABoxHasSixPlanarOnesWithTheirFrames) {
  geometry::Mesh mesh;
  append(mesh, geometry::makeBox({0, 0, 0}, {4, 3, 2.5F}), 0);
  const Charts charts = makeCharts(mesh, bothSides(mesh), 0.1);
  ASSERT_EQ(charts.charts.size(), 6U);
  expectPartition(mesh, charts);
  constexpr float kRoundoff = 1e-6F;
  for (const Chart& c : charts.charts) {
    EXPECT_TRUE(c.planar);
    EXPECT_NEAR(glm::dot(glm::cross(c.t, c.b), c.normal), 1.0F, kRoundoff);  // right-handed, unit
    EXPECT_NEAR(static_cast<double>(c.size.x) * static_cast<double>(c.size.y), c.area, 1e-5);
    for (std::uint32_t k = 0; k < c.triangle_count; ++k) {
      for (int i = 0; i < 3; ++i) {
        const vec3 d =
            mesh.positions[mesh.triangles[charts.triangles[c.first_triangle + k]][i]] - c.origin;
        EXPECT_NEAR(glm::dot(d, c.normal), 0.0F, 4 * kRoundoff);
        EXPECT_GE(glm::dot(d, c.t), -4 * kRoundoff);
        EXPECT_LE(glm::dot(d, c.t), c.size.x + 4 * kRoundoff);
        EXPECT_GE(glm::dot(d, c.b), -4 * kRoundoff);
        EXPECT_LE(glm::dot(d, c.b), c.size.y + 4 * kRoundoff);
      }
    }
  }
}

TEST(Charts, AreCutWhereMaterialOrSidesChange) {
  geometry::Mesh mesh;
  append(mesh, geometry::makeRectangle(2, 1, 2, 1), 0);
  ASSERT_EQ(mesh.triangles.size(), 4U);
  EXPECT_EQ(makeCharts(mesh, bothSides(mesh), 0.1).charts.size(), 1U);
  std::vector<std::uint8_t> sides = bothSides(mesh);
  sides[2] = sides[3] = kFront;
  const Charts by_side = makeCharts(mesh, sides, 0.1);
  EXPECT_EQ(by_side.charts.size(), 2U);
  expectPartition(mesh, by_side);
  mesh.material_of[2] = mesh.material_of[3] = 1;
  const Charts by_material = makeCharts(mesh, bothSides(mesh), 0.1);
  EXPECT_EQ(by_material.charts.size(), 2U);
  expectPartition(mesh, by_material);
}

TEST(Charts, ABallOfSmallTrianglesBecomesPatchesOfOneCellAtMost) {
  geometry::Mesh mesh;
  append(mesh, geometry::makeSphere({0, 0, 0}, 0.5F, 24), 0);
  constexpr double kCell = 0.2;
  const Charts charts = makeCharts(mesh, bothSides(mesh), kCell);
  expectPartition(mesh, charts);
  EXPECT_LT(charts.charts.size(), mesh.triangles.size() / 2);
  for (const Chart& c : charts.charts) {
    if (c.planar) continue;
    EXPECT_LE(c.area, kCell * kCell * (1 + 1e-6));
    for (std::uint32_t k = 0; k < c.triangle_count; ++k) {
      const uvec3& t = mesh.triangles[charts.triangles[c.first_triangle + k]];
      const vec3 n = glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                mesh.positions[t.z] - mesh.positions[t.x]);
      // Within 40 degrees of the seed, so within 80 of each other and of the mean.
      EXPECT_GT(glm::dot(glm::normalize(n), c.normal), std::cos(80.0F * 3.1415927F / 180.0F));
    }
  }
}

TEST(Charts, DoNotDependOnChance) {
  const geometry::Mesh mesh = roomMesh();
  const Charts a = makeCharts(mesh, bothSides(mesh), 0.1);
  const Charts b = makeCharts(mesh, bothSides(mesh), 0.1);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.chart_of, b.chart_of);
}

}  // namespace
}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#include "core/transfer/cell_grid.h"

#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace soffit::transfer {
namespace {

using namespace testing;

/// A flat polygon as a fan about its first corner, in the plane z = 1.
geometry::Mesh fan(const std::vector<vec2>& corners) {
  geometry::Mesh mesh;
  for (const vec2& c : corners) mesh.positions.emplace_back(c, 1.0F);
  for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) mesh.triangles.emplace_back(0U, i, i + 1);
  mesh.material_of.assign(mesh.triangles.size(), 0);
  return mesh;
}

struct Cut {
  geometry::Mesh mesh;
  Charts charts;
  CellGrid grid;
};

Cut cut(geometry::Mesh mesh, double wished) {
  Cut out{std::move(mesh), {}, {}};
  const std::vector<std::uint8_t> sides(out.mesh.triangles.size(), kBothSides);
  out.charts = makeCharts(out.mesh, sides, wished);
  EXPECT_EQ(out.charts.charts.size(), 1U);
  const GridLayout layout = gridLayout(out.charts.charts[0].size, wished, false);
  out.grid = cutIntoCells(out.mesh, out.charts, out.charts.charts[0], layout.nu, layout.nv);
  return out;
}

bool insideTriangle(const geometry::Mesh& mesh, std::uint32_t triangle, const vec3& p,
                    double slack) {
  const uvec3& t = mesh.triangles[triangle];
  for (int i = 0; i < 3; ++i) {
    const dvec3 a(mesh.positions[t[i]]);
    const dvec3 e = dvec3(mesh.positions[t[(i + 1) % 3]]) - a;
    if (glm::cross(e, dvec3(p) - a).z < -slack * glm::length(e)) return false;
  }
  return true;
}

/// Areas add up, owners own themselves, points lie on the chart.
void expectSound(const Cut& c) {
  const auto count = static_cast<std::size_t>(c.grid.nu) * static_cast<std::size_t>(c.grid.nv);
  ASSERT_EQ(c.grid.cells.size(), count);
  double area = 0.0;
  double total = 0.0;
  for (const Cell& cell : c.grid.cells) {
    area += cell.area;
    total += cell.total_area;
    EXPECT_GE(cell.area, 0.0);
    if (cell.area <= 0.0) continue;
    ASSERT_LT(cell.owner, count);
    EXPECT_EQ(c.grid.cells[cell.owner].owner, cell.owner);
    bool on = false;
    for (std::uint32_t t = 0; t < c.mesh.triangles.size(); ++t)
      on = on || insideTriangle(c.mesh, t, cell.point, 1e-5);
    EXPECT_TRUE(on);
    EXPECT_LT(cell.triangle, c.mesh.triangles.size());
  }
  const double expected = c.charts.charts[0].area;
  // Corners in single precision.
  EXPECT_NEAR(area, expected, 1e-5 * expected);
  EXPECT_NEAR(total, expected, 1e-5 * expected);
}

TEST(CellGrid, ARectangleDividesEvenly) {
  const Cut c = cut(fan({{0, 0}, {4.1F, 0}, {4.1F, 3}, {0, 3}}), 0.1);
  EXPECT_EQ(c.grid.nu * c.grid.nv, 1230);
  expectSound(c);
  for (const Cell& cell : c.grid.cells) EXPECT_NEAR(cell.area, 0.01, 1e-6);
}

TEST(CellGrid, ATriangleAndADiskKeepTheirArea) {
  expectSound(cut(fan({{0, 0}, {3, 0}, {1, 2}}), 0.13));
  std::vector<vec2> rim;
  for (int i = 0; i < 48; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 48;
    rim.emplace_back(std::cos(a), std::sin(a));
  }
  expectSound(cut(fan(rim), 0.11));
}

TEST(CellGrid, SliversJoinANeighbour) {
  // The slanted edge leaves slivers.
  const Cut c = cut(fan({{0, 0}, {2, 0}, {2, 0.02F}, {0, 1.0F}}), 0.1);
  expectSound(c);
  const double full = static_cast<double>(c.grid.cell.x) * static_cast<double>(c.grid.cell.y);
  std::size_t joined = 0;
  for (std::size_t i = 0; i < c.grid.cells.size(); ++i) {
    const Cell& cell = c.grid.cells[i];
    if (cell.area <= 0.0 || cell.owner == i) continue;
    ++joined;
    EXPECT_LT(cell.area, 0.05 * full);
    EXPECT_EQ(cell.total_area, 0.0);
    EXPECT_GT(c.grid.cells[cell.owner].total_area, c.grid.cells[cell.owner].area);
  }
  EXPECT_GT(joined, 0U);
}

TEST(CellGrid, NothingIsLostWhereADiagonalMeetsTheGridsCorners) {
  // Whole numbers of cells along both sides: the diagonal passes through corners of cells, where
  // rounding puts it now on one side, now on the other.
  const Cut c = cut(fan({{0, 0}, {4, 0}, {4, 3}, {0, 3}}), 0.1);
  expectSound(c);
  for (const Cell& cell : c.grid.cells) EXPECT_NEAR(cell.area, 0.01, 1e-6);
}

TEST(CellGrid, SmallerThanACellItIsOneCell) {
  const Cut c = cut(fan({{0, 0}, {0.1F, 0}, {0.1F, 0.1F}, {0, 0.1F}}), 0.12);
  EXPECT_EQ(c.grid.cells.size(), 1U);
  expectSound(c);
}

}  // namespace
}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#include "core/transfer/cell_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::transfer {
namespace {

/// A convex polygon in the chart's plane; clipping a triangle by four lines leaves at most 7
/// corners.
struct Piece {
  std::array<dvec2, 8> corners{};
  int count = 0;
};

/// Keeps sign * (p[axis] - at) >= 0.
Piece clip(const Piece& in, int axis, double at, double sign) {
  Piece out;
  for (int i = 0; i < in.count; ++i) {
    const dvec2& a = in.corners[static_cast<std::size_t>(i)];
    const dvec2& b = in.corners[static_cast<std::size_t>((i + 1) % in.count)];
    const double ha = sign * (a[axis] - at);
    const double hb = sign * (b[axis] - at);
    if (ha >= 0.0 && out.count < 8) out.corners[static_cast<std::size_t>(out.count++)] = a;
    if ((ha > 0.0) != (hb > 0.0) && ha != hb && out.count < 8) {
      const double t = ha / (ha - hb);
      out.corners[static_cast<std::size_t>(out.count++)] = a + std::clamp(t, 0.0, 1.0) * (b - a);
    }
  }
  return out;
}

struct Moment {
  double area = 0.0;
  dvec2 center{0.0};
};

Moment momentOf(const Piece& p) {
  Moment m;
  for (int i = 1; i + 1 < p.count; ++i) {
    const dvec2 a = p.corners[static_cast<std::size_t>(i)] - p.corners[0];
    const dvec2 b = p.corners[static_cast<std::size_t>(i + 1)] - p.corners[0];
    const double area = 0.5 * std::abs(a.x * b.y - a.y * b.x);
    m.area += area;
    m.center += area * (p.corners[0] + (a + b) / 3.0);
  }
  if (m.area > 0.0) m.center /= m.area;
  return m;
}

bool contains(const Piece& p, const dvec2& q) {
  bool left = true;
  bool right = true;
  for (int i = 0; i < p.count; ++i) {
    const dvec2 a = p.corners[static_cast<std::size_t>(i)];
    const dvec2 e = p.corners[static_cast<std::size_t>((i + 1) % p.count)] - a;
    const double side = e.x * (q.y - a.y) - e.y * (q.x - a.x);
    left = left && side >= 0.0;
    right = right && side <= 0.0;
  }
  return left || right;
}

/// What gathers in a cell while the triangles pass.
struct Sum {
  dvec2 weighted{0.0};
  double largest = 0.0;
  dvec2 largest_center{0.0};
  std::vector<Piece> pieces;
};

void joinSlivers(CellGrid& grid) {
  const double full = static_cast<double>(grid.cell.x) * static_cast<double>(grid.cell.y);
  const auto index = [&](int i, int j) { return static_cast<std::size_t>(j * grid.nu + i); };
  for (int j = 0; j < grid.nv; ++j) {
    for (int i = 0; i < grid.nu; ++i) {
      Cell& cell = grid.cells[index(i, j)];
      if (cell.area <= 0.0 || cell.area >= 0.05 * full) continue;
      Cell* best = nullptr;
      std::size_t best_index = 0;
      for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        if (i + di < 0 || j + dj < 0 || i + di >= grid.nu || j + dj >= grid.nv) continue;
        Cell& other = grid.cells[index(i + di, j + dj)];
        if (other.area >= 0.05 * full && (best == nullptr || other.area > best->area)) {
          best = &other;
          best_index = index(i + di, j + dj);
        }
      }
      if (best == nullptr) continue;
      best->total_area += cell.area;
      cell.owner = static_cast<std::uint32_t>(best_index);
      cell.total_area = 0.0;
    }
  }
}

}  // namespace

GridLayout gridLayout(const vec2& size, double wished, bool fine) {
  constexpr int kMost = 2048;  // base cells along an axis
  const auto cells = [&](float extent) {
    return std::clamp(static_cast<int>(std::lround(static_cast<double>(extent) / wished)), 1,
                      kMost);
  };
  const auto parts = [&](float extent, int count) {
    const double share = static_cast<double>(extent) / count / wished;
    return !fine || share < 0.12 ? 1 : (share < 0.5 ? 2 : 4);
  };
  GridLayout layout;
  layout.nu = cells(size.x);
  layout.nv = cells(size.y);
  layout.ku = parts(size.x, layout.nu);
  layout.kv = parts(size.y, layout.nv);
  layout.nu *= layout.ku;
  layout.nv *= layout.kv;
  return layout;
}

CellGrid cutIntoCells(const geometry::Mesh& mesh, const Charts& charts, const Chart& chart, int nu,
                      int nv) {
  CellGrid grid;
  const dvec2 size(chart.size);
  grid.nu = nu;
  grid.nv = nv;
  const dvec2 cell(std::max(size.x / grid.nu, 1e-30), std::max(size.y / grid.nv, 1e-30));
  grid.cell = vec2(cell);
  grid.cells.resize(static_cast<std::size_t>(grid.nu) * static_cast<std::size_t>(grid.nv));
  std::vector<Sum> sums(grid.cells.size());
  for (std::uint32_t k = 0; k < chart.triangle_count; ++k) {
    const std::uint32_t t = charts.triangles[chart.first_triangle + k];
    Piece triangle;
    triangle.count = 3;
    dvec2 lo(1e300);
    dvec2 hi(-1e300);
    for (int c = 0; c < 3; ++c) {
      const dvec3 d = dvec3(mesh.positions[mesh.triangles[t][c]]) - dvec3(chart.origin);
      const dvec2 q(glm::dot(d, dvec3(chart.t)), glm::dot(d, dvec3(chart.b)));
      triangle.corners[static_cast<std::size_t>(c)] = q;
      lo = glm::min(lo, q);
      hi = glm::max(hi, q);
    }
    const int j0 = std::clamp(static_cast<int>(std::floor(lo.y / cell.y)), 0, grid.nv - 1);
    const int j1 = std::clamp(static_cast<int>(std::floor(hi.y / cell.y)), 0, grid.nv - 1);
    for (int j = j0; j <= j1; ++j) {
      // Border cells take what rounding leaves outside the grid.
      Piece row = triangle;
      if (j > 0) row = clip(row, 1, j * cell.y, 1.0);
      if (j + 1 < grid.nv) row = clip(row, 1, (j + 1) * cell.y, -1.0);
      if (row.count < 3) continue;
      double left = 1e300;
      double right = -1e300;
      for (int c = 0; c < row.count; ++c) {
        left = std::min(left, row.corners[static_cast<std::size_t>(c)].x);
        right = std::max(right, row.corners[static_cast<std::size_t>(c)].x);
      }
      const int i0 = std::clamp(static_cast<int>(std::floor(left / cell.x)), 0, grid.nu - 1);
      const int i1 = std::clamp(static_cast<int>(std::floor(right / cell.x)), 0, grid.nu - 1);
      for (int i = i0; i <= i1; ++i) {
        Piece piece = row;
        if (i > 0) piece = clip(piece, 0, i * cell.x, 1.0);
        if (i + 1 < grid.nu) piece = clip(piece, 0, (i + 1) * cell.x, -1.0);
        if (piece.count < 3) continue;
        const Moment m = momentOf(piece);
        if (m.area <= 0.0) continue;
        const auto index = static_cast<std::size_t>(j * grid.nu + i);
        Sum& sum = sums[index];
        Cell& target = grid.cells[index];
        target.area += m.area;
        sum.weighted += m.area * m.center;
        sum.pieces.push_back(piece);
        if (m.area > sum.largest) {
          sum.largest = m.area;
          sum.largest_center = m.center;
          target.triangle = t;
        }
      }
    }
  }
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    Cell& c = grid.cells[i];
    c.owner = static_cast<std::uint32_t>(i);
    c.total_area = c.area;
    if (c.area <= 0.0) continue;
    dvec2 q = sums[i].weighted / c.area;
    const bool inside = std::any_of(sums[i].pieces.begin(), sums[i].pieces.end(),
                                    [&](const Piece& p) { return contains(p, q); });
    if (!inside) q = sums[i].largest_center;
    c.point = vec3(dvec3(chart.origin) + q.x * dvec3(chart.t) + q.y * dvec3(chart.b));
  }
  joinSlivers(grid);
  return grid;
}

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#include "ui/viewport/chart_cutting.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace soffit::ui {
namespace {

/// Polygons in lattice coordinates: base cells, whole numbers where the cuts run.
using Polygon = std::vector<dvec2>;

/// Corners nearer than this share of a cell are one.
constexpr double kSnap = 1.0 / 4096.0;

/// The part of a convex polygon where axis `k` lies in [lo, hi]; corners made by a cut lie on it
/// exactly.
Polygon clipped(const Polygon& polygon, int k, double lo, double hi) {
  const auto cut = [k](const Polygon& in, double limit, double sign) {
    Polygon out;
    for (std::size_t i = 0; i < in.size(); ++i) {
      const dvec2& a = in[i];
      const dvec2& b = in[(i + 1) % in.size()];
      const double da = sign * (a[k] - limit);
      const double db = sign * (b[k] - limit);
      if (da >= 0.0) out.push_back(a);
      if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) {
        // From the same end whichever way the edge runs: both neighbours get the same corner.
        const bool forward = a.x < b.x || (a.x == b.x && a.y < b.y);
        const dvec2& p = forward ? a : b;
        const dvec2& q = forward ? b : a;
        dvec2 corner = p + (q - p) * ((limit - p[k]) / (q[k] - p[k]));
        corner[k] = limit;
        out.push_back(corner);
      }
    }
    return out;
  };
  return cut(cut(polygon, lo, 1.0), hi, -1.0);
}

/// How finely the lattice is cut: texels are whole base cells, halves of them, or fine cells.
class Fineness {
 public:
  Fineness(const transfer::Texels& texels, std::uint32_t chart, int side)
      : grid_(texels.grids[chart]),
        columns_(grid_.nu / grid_.ku),
        rows_(grid_.nv / grid_.kv),
        texels_(texels),
        first_base_(grid_.first_base + static_cast<std::uint32_t>(side * columns_ * rows_)),
        first_cell_(grid_.first + static_cast<std::uint32_t>(side * grid_.nu * grid_.nv)) {}

  /// 1, 2 or 4 parts along each side of the lattice cell (i, j), which spans the base cells i..i+1,
  /// j..j+1 between their centers.
  [[nodiscard]] int level(int i, int j) const {
    if (grid_.ku == 1 && grid_.kv == 1) return 1;
    int most = 1;
    for (int dj = 0; dj < 2; ++dj) {
      for (int di = 0; di < 2; ++di) {
        most = std::max(most, levelOfBase(std::clamp(i + di, 0, columns_ - 1),
                                          std::clamp(j + dj, 0, rows_ - 1)));
      }
    }
    return most;
  }
  [[nodiscard]] int parts(int axis, int level) const {
    return std::min(level, axis == 0 ? grid_.ku : grid_.kv);
  }

 private:
  [[nodiscard]] int levelOfBase(int u, int v) const {
    if (texels_.split[first_base_ + static_cast<std::uint32_t>(v * columns_ + u)] == 0) return 1;
    const auto slot = [&](int di, int dj) {
      const int at = (v * grid_.kv + dj) * grid_.nu + u * grid_.ku + di;
      return texels_.cells[first_cell_ + static_cast<std::uint32_t>(at)];
    };
    // Halves: each pair of fine cells along a side is one texel.
    for (int dj = 0; dj < grid_.kv; ++dj) {
      for (int di = 0; di < grid_.ku; ++di) {
        const int hi = grid_.ku == 4 ? di & ~1 : di;
        const int hj = grid_.kv == 4 ? dj & ~1 : dj;
        if (slot(di, dj) != slot(hi, hj)) return 4;
      }
    }
    return 2;
  }

  const transfer::Texels::Grid& grid_;
  int columns_;
  int rows_;
  const transfer::Texels& texels_;
  std::uint32_t first_base_;
  std::uint32_t first_cell_;
};

class Cutter {
 public:
  Cutter(const geometry::Mesh& mesh, const transfer::Texels& texels, std::uint32_t chart, int side)
      : mesh_(mesh),
        chart_(texels.charts.charts[chart]),
        fineness_(texels, chart, side),
        base_(texels.grids[chart].cell.x * static_cast<float>(texels.grids[chart].ku),
              texels.grids[chart].cell.y * static_cast<float>(texels.grids[chart].kv)) {}

  void add(std::uint32_t triangle) {
    triangle_ = triangle;
    const uvec3& t = mesh_.triangles[triangle];
    const Polygon corners{toLattice(t.x), toLattice(t.y), toLattice(t.z)};
    a_ = corners[0];
    edge_u_ = corners[1] - corners[0];
    edge_v_ = corners[2] - corners[0];
    area_ = edge_u_.x * edge_v_.y - edge_u_.y * edge_v_.x;
    if (area_ == 0.0) return;
    strips(corners, 0, [&](const Polygon& column, int i) {
      strips(column, 1, [&](const Polygon& cell, int j) { addCell(cell, i, j); });
    });
  }

  CutChart take() { return std::move(out_); }

 private:
  [[nodiscard]] dvec2 toLattice(std::uint32_t vertex) const {
    const dvec3 d = dvec3(mesh_.positions[vertex]) - dvec3(chart_.origin);
    return dvec2(glm::dot(d, dvec3(chart_.t)), glm::dot(d, dvec3(chart_.b))) / base_ - 0.5;
  }

  template <class Body>
  static void strips(const Polygon& polygon, int axis, const Body& body) {
    double lo = polygon.front()[axis];
    double hi = lo;
    for (const dvec2& p : polygon) {
      lo = std::min(lo, p[axis]);
      hi = std::max(hi, p[axis]);
    }
    for (int k = static_cast<int>(std::floor(lo)); k < hi; ++k) {
      const Polygon strip = clipped(polygon, axis, k, k + 1);
      if (strip.size() >= 3) body(strip, k);
    }
  }

  void addCell(const Polygon& cell, int i, int j) {
    const int level = fineness_.level(i, j);
    const int nu = fineness_.parts(0, level);
    const int nv = fineness_.parts(1, level);
    const auto place = [](int from, int k, int n) { return from + static_cast<double>(k) / n; };
    for (int u = 0; u < nu; ++u) {
      const Polygon column =
          nu == 1 ? cell : clipped(cell, 0, place(i, u, nu), place(i, u + 1, nu));
      if (column.size() < 3) continue;
      for (int v = 0; v < nv; ++v) {
        const Polygon part =
            nv == 1 ? column : clipped(column, 1, place(j, v, nv), place(j, v + 1, nv));
        if (part.size() >= 3) fan(withNeighboursCorners(part, i, j, level));
      }
    }
  }

  /// The corners of finer neighbours on the lattice cell's border, so that no T-junction is left.
  [[nodiscard]] Polygon withNeighboursCorners(const Polygon& part, int i, int j, int level) const {
    Polygon out;
    for (std::size_t k = 0; k < part.size(); ++k) {
      const dvec2& a = part[k];
      const dvec2& b = part[(k + 1) % part.size()];
      out.push_back(a);
      for (int axis = 0; axis < 2; ++axis) {
        const int at = axis == 0 ? i : j;
        if (a[axis] != b[axis] || (a[axis] != at && a[axis] != at + 1)) continue;
        const int step = a[axis] == at ? -1 : 1;
        const int beyond = axis == 0 ? fineness_.level(i + step, j) : fineness_.level(i, j + step);
        if (beyond <= level) continue;
        const int other = 1 - axis;
        const int parts = fineness_.parts(other, beyond);
        const int from = other == 0 ? i : j;
        const bool rising = b[other] > a[other];
        for (int m = 1; m < parts; ++m) {
          const double place = from + static_cast<double>(rising ? m : parts - m) / parts;
          if (place <= std::min(a[other], b[other]) || place >= std::max(a[other], b[other]))
            continue;
          dvec2 corner = a;
          corner[other] = place;
          out.push_back(corner);
        }
      }
    }
    return out;
  }

  void fan(const Polygon& polygon) {
    std::vector<std::uint32_t> corners;
    for (const dvec2& p : polygon) {
      const std::uint32_t v = vertex(p);
      if (corners.empty() || (corners.back() != v && corners.front() != v)) corners.push_back(v);
    }
    for (std::size_t k = 2; k < corners.size(); ++k) {
      out_.triangles.emplace_back(corners[0], corners[k - 1], corners[k]);
    }
  }

  std::uint32_t vertex(const dvec2& p) {
    const auto x = static_cast<std::int64_t>(std::llround(p.x / kSnap));
    const auto y = static_cast<std::int64_t>(std::llround(p.y / kSnap));
    const auto key = (x << 32) ^ (y & 0xffffffffLL);
    const auto [found, added] =
        known_.try_emplace(key, static_cast<std::uint32_t>(out_.vertices.size()));
    if (added) {
      const dvec2 d = p - a_;
      const double u = (d.x * edge_v_.y - d.y * edge_v_.x) / area_;
      const double v = (edge_u_.x * d.y - edge_u_.y * d.x) / area_;
      out_.vertices.push_back({vec2((p + 0.5) * base_), triangle_, vec2(u, v)});
    }
    return found->second;
  }

  const geometry::Mesh& mesh_;
  const transfer::Chart& chart_;
  Fineness fineness_;
  dvec2 base_;
  std::uint32_t triangle_ = 0;
  dvec2 a_{0.0};
  dvec2 edge_u_{0.0};
  dvec2 edge_v_{0.0};
  double area_ = 0.0;
  std::unordered_map<std::int64_t, std::uint32_t> known_;
  CutChart out_;
};

}  // namespace

CutChart cutChart(const geometry::Mesh& mesh, const transfer::Texels& texels, std::uint32_t chart,
                  int side) {
  Cutter cutter(mesh, texels, chart, side);
  const transfer::Chart& c = texels.charts.charts[chart];
  for (std::uint32_t k = 0; k < c.triangle_count; ++k) {
    cutter.add(texels.charts.triangles[c.first_triangle + k]);
  }
  return cutter.take();
}

}  // namespace soffit::ui

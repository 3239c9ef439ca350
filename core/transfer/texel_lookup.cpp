// SPDX-License-Identifier: MIT
#include "core/transfer/texels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soffit::transfer {

std::uint32_t Texels::at(std::uint32_t mesh_triangle, bool front, const vec3& point) const {
  const std::uint32_t c = charts.chart_of[mesh_triangle];
  const Chart& chart = charts.charts[c];
  if ((chart.sides & (front ? kFront : kBack)) == 0) return kNoTexel;
  const Grid& grid = grids[c];
  const std::uint32_t base =
      grid.first + sideOffset(chart, front, static_cast<std::uint32_t>(grid.nu * grid.nv));
  if (!chart.planar) return cells[base];
  const vec3 d = point - chart.origin;
  const int i = std::clamp(static_cast<int>(glm::dot(d, chart.t) / grid.cell.x), 0, grid.nu - 1);
  const int j = std::clamp(static_cast<int>(glm::dot(d, chart.b) / grid.cell.y), 0, grid.nv - 1);
  const auto index = static_cast<std::uint32_t>(j * grid.nu + i);
  if (cells[base + index] != kNoTexel) return cells[base + index];
  // Rounding put the point over a chart's slanted edge, or it lies under what covers the cell: the
  // nearest cell with a texel. Any other may be in the light where this one is in a shadow.
  const vec2 place(glm::dot(d, chart.t) / grid.cell.x, glm::dot(d, chart.b) / grid.cell.y);
  std::uint32_t nearest = kNoTexel;
  float least = std::numeric_limits<float>::infinity();
  for (int y = std::max(j - 2, 0); y <= std::min(j + 2, grid.nv - 1); ++y) {
    for (int x = std::max(i - 2, 0); x <= std::min(i + 2, grid.nu - 1); ++x) {
      const std::uint32_t slot = cells[base + static_cast<std::uint32_t>(y * grid.nu + x)];
      if (slot == kNoTexel) continue;
      const vec2 off =
          (vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5F - place) * grid.cell;
      if (glm::dot(off, off) >= least) continue;
      least = glm::dot(off, off);
      nearest = slot;
    }
  }
  return nearest;
}

/// Collects the texels that a point's light is interpolated from: those of up to 2 x 2 base cells.
struct Texels::Near {
  const Texels& texels;
  const Grid& grid;
  std::uint32_t first;  // cell of the side
  std::uint32_t part;
  vec2 at;            // in fine cells
  int i0, j0;         // the lowest fine cell of the base cells
  int columns, rows;  // fine cells of theirs, 64 at most
  std::array<std::uint32_t, kMostAround>& slots;
  std::array<float, kMostAround>& weights;
  std::uint64_t reached = ~std::uint64_t{0};  // bit j * columns + i: of the base cells' fine cells
  std::size_t count = 0;
  float sum = 0.0F;

  [[nodiscard]] std::uint32_t cellAt(int i, int j) const {
    return first + static_cast<std::uint32_t>(j * grid.nu + i);
  }
  [[nodiscard]] std::uint64_t bitOf(int i, int j) const {
    return std::uint64_t{1} << static_cast<unsigned>((j - j0) * columns + i - i0);
  }

  /// Leaves those fine cells that the texel's own are joined to, round the end of a screen at most
  /// as far as the base cells reach. Covered cells are joined to none: the numbers that they have
  /// are lent, and may be those from behind a wall.
  void reachFrom(std::uint32_t own) {
    if (texels.links.empty()) return;
    std::uint64_t start = 0;
    std::uint64_t along = 0;   // open to the next in the row
    std::uint64_t across = 0;  // to the next row
    bool walls = false;
    for (int j = j0; j < j0 + rows; ++j) {
      for (int i = i0; i < i0 + columns; ++i) {
        const std::uint32_t index = cellAt(i, j);
        const std::uint8_t open = texels.links[index];
        if (texels.cells[index] == own) start |= bitOf(i, j);
        if (i + 1 < i0 + columns) ((open & 1U) != 0 ? along |= bitOf(i, j) : walls = true);
        if (j + 1 < j0 + rows) ((open & 2U) != 0 ? across |= bitOf(i, j) : walls = true);
      }
    }
    if (!walls || start == 0) return;
    reached = start;
    const auto row = static_cast<unsigned>(columns);
    for (std::uint64_t before = 0; before != reached;) {
      before = reached;
      reached |= (reached & along) << 1U | (reached >> 1U & along);
      reached |= (reached & across) << row | (reached >> row & across);
    }
  }

  void add(int i, int j, float weight) {
    if (weight <= 0.0F || (reached & bitOf(i, j)) == 0) return;
    const std::uint32_t slot = texels.cells[cellAt(i, j)];
    if (slot == kNoTexel || texels.part[slot] != part) return;
    sum += weight;
    for (std::size_t k = 0; k < count; ++k) {
      if (slots[k] != slot) continue;
      weights[k] += weight;
      return;
    }
    slots[count] = slot;
    weights[count++] = weight;
  }

  /// Of a base cell that is one texel: any of its fine cells that has it.
  void addWhole(int i_base, int j_base, float weight) {
    for (int j = j_base; j < j_base + grid.kv; ++j) {
      for (int i = i_base; i < i_base + grid.ku; ++i) {
        if ((reached & bitOf(i, j)) == 0 || texels.cells[cellAt(i, j)] == kNoTexel) continue;
        add(i, j, weight);
        return;
      }
    }
  }

  void addSplit(int i_base, int j_base, float weight) {
    const float x =
        std::clamp(at.x - 0.5F - static_cast<float>(i_base), 0.0F, static_cast<float>(grid.ku - 1));
    const float y =
        std::clamp(at.y - 0.5F - static_cast<float>(j_base), 0.0F, static_cast<float>(grid.kv - 1));
    const int i = static_cast<int>(x);
    const int j = static_cast<int>(y);
    const float fx = x - static_cast<float>(i);
    const float fy = y - static_cast<float>(j);
    for (int dj = 0; dj < 2 && j + dj < grid.kv; ++dj) {
      for (int di = 0; di < 2 && i + di < grid.ku; ++di) {
        add(i_base + i + di, j_base + j + dj,
            weight * (di == 0 ? 1.0F - fx : fx) * (dj == 0 ? 1.0F - fy : fy));
      }
    }
  }
};

int Texels::around(std::uint32_t mesh_triangle, bool front, const vec3& point,
                   std::array<std::uint32_t, kMostAround>& slots,
                   std::array<float, kMostAround>& weights) const {
  const std::uint32_t c = charts.chart_of[mesh_triangle];
  const Chart& chart = charts.charts[c];
  const std::uint32_t own = at(mesh_triangle, front, point);
  if (own == kNoTexel) return 0;
  slots[0] = own;
  weights[0] = 1.0F;
  if (!chart.planar) return 1;
  const Grid& grid = grids[c];
  const int columns = grid.nu / grid.ku;
  const int rows = grid.nv / grid.kv;
  const vec3 d = point - chart.origin;
  const vec2 place(glm::dot(d, chart.t) / grid.cell.x, glm::dot(d, chart.b) / grid.cell.y);
  const std::uint32_t first_base =
      grid.first_base + sideOffset(chart, front, static_cast<std::uint32_t>(columns * rows));
  const float x = std::clamp(place.x / static_cast<float>(grid.ku) - 0.5F, 0.0F,
                             static_cast<float>(columns - 1));
  const float y =
      std::clamp(place.y / static_cast<float>(grid.kv) - 0.5F, 0.0F, static_cast<float>(rows - 1));
  const int i = static_cast<int>(x);
  const int j = static_cast<int>(y);
  Near near{*this,
            grid,
            grid.first + sideOffset(chart, front, static_cast<std::uint32_t>(grid.nu * grid.nv)),
            part[own],
            place,
            i * grid.ku,
            j * grid.kv,
            grid.ku * std::min(2, columns - i),
            grid.kv * std::min(2, rows - j),
            slots,
            weights};
  near.reachFrom(own);
  for (int dj = 0; dj < 2 && j + dj < rows; ++dj) {
    for (int di = 0; di < 2 && i + di < columns; ++di) {
      const float wx = di == 0 ? 1.0F - (x - static_cast<float>(i)) : x - static_cast<float>(i);
      const float wy = dj == 0 ? 1.0F - (y - static_cast<float>(j)) : y - static_cast<float>(j);
      const int i0 = (i + di) * grid.ku;
      const int j0 = (j + dj) * grid.kv;
      if (split[first_base + static_cast<std::uint32_t>((j + dj) * columns + i + di)] != 0) {
        near.addSplit(i0, j0, wx * wy);
      } else {
        near.addWhole(i0, j0, wx * wy);
      }
    }
  }
  if (near.count == 0 || near.sum <= 1e-6F) {
    slots[0] = own;
    weights[0] = 1.0F;
    return 1;
  }
  for (std::size_t k = 0; k < near.count; ++k) weights[k] /= near.sum;
  return static_cast<int>(near.count);
}

}  // namespace soffit::transfer

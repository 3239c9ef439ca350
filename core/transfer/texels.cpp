// SPDX-License-Identifier: MIT
#include "core/transfer/texels.h"

#include "core/transfer/cell_grid.h"
#include "core/transfer/exposure.h"
#include "core/transfer/regions.h"

#include <algorithm>
#include <cmath>

namespace soffit::transfer {
namespace {

constexpr std::uint32_t kClusterSize = 256;

/// Texels before they are put in the order of their clusters.
struct Draft {
  std::vector<vec3> position, normal;
  std::vector<float> area;
  std::vector<std::uint32_t> material, triangle;

  std::uint32_t add(const vec3& p, const vec3& n, double a, std::uint32_t m, std::uint32_t t) {
    position.push_back(p);
    normal.push_back(n);
    area.push_back(static_cast<float>(a));
    material.push_back(m);
    triangle.push_back(t);
    return static_cast<std::uint32_t>(position.size() - 1);
  }
};

void addPlanarChart(const geometry::Mesh& mesh, const Charts& charts, const Chart& chart, double cell, Draft& draft,
                    Texels& out, Texels::Grid& grid) {
  const CellGrid cut = cutIntoCells(mesh, charts, chart, cell);
  grid.nu = cut.nu;
  grid.nv = cut.nv;
  grid.cell = cut.cell;
  const auto count = static_cast<std::size_t>(cut.nu) * static_cast<std::size_t>(cut.nv);
  for (const Sides side : {kFront, kBack}) {
    if ((chart.sides & side) == 0) continue;
    const std::size_t base = out.cells.size();
    out.cells.resize(base + count, kNoTexel);
    const vec3 n = side == kFront ? chart.normal : -chart.normal;
    for (std::size_t i = 0; i < count; ++i) {
      const Cell& c = cut.cells[i];
      if (c.owner != i || c.area <= 0.0) continue;
      out.cells[base + i] = draft.add(c.point, n, c.total_area, chart.material, c.triangle);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (cut.cells[i].area > 0.0) out.cells[base + i] = out.cells[base + cut.cells[i].owner];
    }
  }
}

void addCurvedChart(const geometry::Mesh& mesh, const Charts& charts, const Chart& chart, Draft& draft, Texels& out) {
  // The point: on the triangle whose centre is nearest to the chart's centre of area.
  dvec3 center(0.0);
  double area = 0.0;
  const auto triangleAt = [&](std::uint32_t k) { return charts.triangles[chart.first_triangle + k]; };
  const auto corners = [&](std::uint32_t t) {
    const uvec3& i = mesh.triangles[t];
    return std::array<dvec3, 3>{dvec3(mesh.positions[i.x]), dvec3(mesh.positions[i.y]), dvec3(mesh.positions[i.z])};
  };
  for (std::uint32_t k = 0; k < chart.triangle_count; ++k) {
    const auto c = corners(triangleAt(k));
    const double a = 0.5 * glm::length(glm::cross(c[1] - c[0], c[2] - c[0]));
    center += a / 3.0 * (c[0] + c[1] + c[2]);
    area += a;
  }
  if (area > 0.0) center /= area;
  double best = 1e300;
  dvec3 point(center);
  std::uint32_t on = triangleAt(0);
  for (std::uint32_t k = 0; k < chart.triangle_count; ++k) {
    const auto c = corners(triangleAt(k));
    const dvec3 middle = (c[0] + c[1] + c[2]) / 3.0;
    const double distance = glm::dot(middle - center, middle - center);
    if (distance < best) {
      best = distance;
      point = middle;
      on = triangleAt(k);
    }
  }
  for (const Sides side : {kFront, kBack}) {
    if ((chart.sides & side) == 0) continue;
    const vec3 n = side == kFront ? chart.normal : -chart.normal;
    out.cells.push_back(draft.add(vec3(point), n, chart.area, chart.material, on));
  }
}

/// How wide a texel of this area is in texture coordinates, by the triangle's ratio of areas.
float uvWidth(const geometry::Mesh& mesh, std::uint32_t triangle, float area) {
  if (mesh.uvs.empty()) return 0.0F;
  const uvec3& t = mesh.triangles[triangle];
  const vec3 n = glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
  const vec2 a = mesh.uvs[t.y] - mesh.uvs[t.x];
  const vec2 b = mesh.uvs[t.z] - mesh.uvs[t.x];
  const float metres = glm::length(n);
  return metres > 0.0F ? std::sqrt(area * std::abs(a.x * b.y - a.y * b.x) / metres) : 0.0F;
}

vec2 uvAt(const geometry::Mesh& mesh, std::uint32_t triangle, const vec3& p) {
  if (mesh.uvs.empty()) return vec2(0.0F);
  const uvec3& t = mesh.triangles[triangle];
  const vec3 a = mesh.positions[t.x];
  const vec3 e1 = mesh.positions[t.y] - a;
  const vec3 e2 = mesh.positions[t.z] - a;
  const vec3 n = glm::cross(e1, e2);
  const float nn = glm::dot(n, n);
  if (nn <= 0.0F) return mesh.uvs[t.x];
  const float u = glm::dot(glm::cross(p - a, e2), n) / nn;
  const float v = glm::dot(glm::cross(e1, p - a), n) / nn;
  return (1.0F - u - v) * mesh.uvs[t.x] + u * mesh.uvs[t.y] + v * mesh.uvs[t.z];
}

}  // namespace

Texels makeTexels(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides, double cell,
                  const geometry::RayCaster* caster) {
  Texels out;
  out.cell = cell;
  out.charts = makeCharts(mesh, sides, cell);
  Draft draft;
  for (const Chart& chart : out.charts.charts) {
    Texels::Grid grid;
    grid.first = static_cast<std::uint32_t>(out.cells.size());
    if (chart.planar) {
      addPlanarChart(mesh, out.charts, chart, cell, draft, out, grid);
    } else {
      addCurvedChart(mesh, out.charts, chart, draft, out);
    }
    out.grids.push_back(grid);
  }
  if (caster != nullptr) {
    measureExposure(mesh, sides, *caster, out, {draft.position, draft.normal, draft.area, draft.triangle});
  }
  const Regions regions = findRegions(out, draft.position, draft.normal, caster);
  out.receivers = light::makeReceivers(draft.position, draft.normal, kClusterSize, regions.number);
  const std::size_t slots = out.receivers.slotCount();
  out.area.assign(slots, 0.0F);
  out.material.resize(slots);
  out.triangle.resize(slots);
  out.openness.resize(slots);
  out.uv.resize(slots);
  out.uv_width.resize(slots);
  for (std::size_t slot = 0; slot < slots; ++slot) {
    const std::uint32_t p = out.receivers.point_of[slot];
    if (out.receivers.slot_of[p] == slot) out.area[slot] = draft.area[p];
    out.material[slot] = draft.material[p];
    out.triangle[slot] = draft.triangle[p];
    out.openness[slot] = regions.openness[p];
    out.uv[slot] = uvAt(mesh, draft.triangle[p], draft.position[p]);
    out.uv_width[slot] = uvWidth(mesh, draft.triangle[p], draft.area[p]);
  }
  for (std::uint32_t& c : out.cells) {
    if (c != kNoTexel) c = out.receivers.slot_of[c];
  }
  return out;
}

double cellForCount(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides, std::size_t count,
                    double least_cell) {
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const uvec3& t = mesh.triangles[i];
    const dvec3 a(mesh.positions[t.x]);
    const double twice = glm::length(glm::cross(dvec3(mesh.positions[t.y]) - a, dvec3(mesh.positions[t.z]) - a));
    area += 0.5 * twice * ((sides[i] & kFront) + ((sides[i] & kBack) >> 1));
  }
  if (area <= 0.0) return std::max(least_cell, 0.1);
  double cell = std::sqrt(area / static_cast<double>(count));
  for (int round = 0; round < 8; ++round) {
    if (cell <= least_cell) return least_cell;
    const auto found = static_cast<double>(makeTexels(mesh, sides, cell, nullptr).texelCount());
    const double ratio = found / static_cast<double>(count);
    if (ratio >= 1.0 && ratio <= 1.03) return cell;
    cell *= std::pow(ratio / 1.015, 0.55);
  }
  while (cell > least_cell && makeTexels(mesh, sides, cell, nullptr).texelCount() < count) cell *= 0.985;
  return std::max(cell, least_cell);
}

std::uint32_t Texels::at(std::uint32_t mesh_triangle, bool front, const vec3& point) const {
  const std::uint32_t c = charts.chart_of[mesh_triangle];
  const Chart& chart = charts.charts[c];
  const Sides side = front ? kFront : kBack;
  if ((chart.sides & side) == 0) return kNoTexel;
  const Grid& grid = grids[c];
  const std::uint32_t per_side = static_cast<std::uint32_t>(grid.nu) * static_cast<std::uint32_t>(grid.nv);
  const std::uint32_t base = grid.first + (!front && (chart.sides & kFront) != 0 ? per_side : 0U);
  if (!chart.planar) return cells[base];
  const vec3 d = point - chart.origin;
  const int i = std::clamp(static_cast<int>(glm::dot(d, chart.t) / grid.cell.x), 0, grid.nu - 1);
  const int j = std::clamp(static_cast<int>(glm::dot(d, chart.b) / grid.cell.y), 0, grid.nv - 1);
  const auto index = static_cast<std::uint32_t>(j * grid.nu + i);
  if (cells[base + index] != kNoTexel) return cells[base + index];
  // Rounding put the point over a chart's slanted edge: the nearest cell with a texel.
  for (int reach = 1; reach <= 2; ++reach) {
    for (int dj = -reach; dj <= reach; ++dj) {
      for (int di = -reach; di <= reach; ++di) {
        if (i + di < 0 || j + dj < 0 || i + di >= grid.nu || j + dj >= grid.nv) continue;
        const std::uint32_t slot = cells[base + static_cast<std::uint32_t>((j + dj) * grid.nu + i + di)];
        if (slot != kNoTexel) return slot;
      }
    }
  }
  return kNoTexel;
}

int Texels::around(std::uint32_t mesh_triangle, bool front, const vec3& point, std::array<std::uint32_t, 4>& slots,
                   std::array<float, 4>& weights) const {
  const std::uint32_t c = charts.chart_of[mesh_triangle];
  const Chart& chart = charts.charts[c];
  const std::uint32_t own = at(mesh_triangle, front, point);
  if (own == kNoTexel) return 0;
  slots[0] = own;
  weights[0] = 1.0F;
  if (!chart.planar) return 1;
  const Grid& grid = grids[c];
  const std::uint32_t per_side = static_cast<std::uint32_t>(grid.nu) * static_cast<std::uint32_t>(grid.nv);
  const std::uint32_t base = grid.first + (!front && (chart.sides & kFront) != 0 ? per_side : 0U);
  const vec3 d = point - chart.origin;
  const float x = std::clamp(glm::dot(d, chart.t) / grid.cell.x - 0.5F, 0.0F, static_cast<float>(grid.nu - 1));
  const float y = std::clamp(glm::dot(d, chart.b) / grid.cell.y - 0.5F, 0.0F, static_cast<float>(grid.nv - 1));
  const int i0 = static_cast<int>(x);
  const int j0 = static_cast<int>(y);
  int count = 0;
  float sum = 0.0F;
  for (int dj = 0; dj < 2; ++dj) {
    for (int di = 0; di < 2; ++di) {
      const int i = i0 + di;
      const int j = j0 + dj;
      if (i >= grid.nu || j >= grid.nv) continue;
      const float wx = di == 0 ? 1.0F - (x - static_cast<float>(i0)) : x - static_cast<float>(i0);
      const float wy = dj == 0 ? 1.0F - (y - static_cast<float>(j0)) : y - static_cast<float>(j0);
      const std::uint32_t slot = cells[base + static_cast<std::uint32_t>(j * grid.nu + i)];
      if (slot == kNoTexel || wx * wy <= 0.0F) continue;
      slots[static_cast<std::size_t>(count)] = slot;
      weights[static_cast<std::size_t>(count)] = wx * wy;
      sum += wx * wy;
      ++count;
    }
  }
  if (count == 0) {
    slots[0] = own;
    weights[0] = 1.0F;
    return 1;
  }
  for (int k = 0; k < count; ++k) weights[static_cast<std::size_t>(k)] /= sum;
  return count;
}

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#include "core/transfer/texels.h"

#include "core/base/parallel.h"
#include "core/transfer/cell_splits.h"
#include "core/transfer/exposure.h"
#include "core/transfer/regions.h"

#include <algorithm>
#include <cmath>

namespace soffit::transfer {
namespace {

constexpr std::uint32_t kClusterSize = 256;
constexpr double kChartShare = 0.7;

/// Texels before they are put in the order of their clusters.
struct Draft {
  std::vector<vec3> position, normal;
  std::vector<float> area;
  std::vector<std::uint32_t> material, triangle;
  std::vector<std::uint8_t> open;  ///< per cell: CellOutlook::open

  std::uint32_t add(const vec3& p, const vec3& n, double a, std::uint32_t m, std::uint32_t t) {
    position.push_back(p);
    normal.push_back(n);
    area.push_back(static_cast<float>(a));
    material.push_back(m);
    triangle.push_back(t);
    return static_cast<std::uint32_t>(position.size() - 1);
  }
};

/// What stands over a point of one side of a chart; without a caster nothing does.
struct CoverProbe {
  const geometry::Mesh& mesh;
  std::span<const std::uint8_t> sides;
  const geometry::RayCaster* caster = nullptr;
  vec3 n{0.0F};
  float gap = 0.0F;
  [[nodiscard]] Cover at(const vec3& p) const {
    return caster == nullptr ? Cover::none : coverOf(mesh, sides, *caster, p, n, gap);
  }
  [[nodiscard]] bool inMatter(const vec3& p) const {
    return caster != nullptr && liesInMatter(mesh, sides, *caster, p, n);
  }
};

/// Exposed cells of a texel under way.
class CellSum {
 public:
  CellSum(const SplitGrid& grid, const Chart& chart, const CoverProbe& probe,
          std::span<const std::size_t> cells)
      : grid_(grid), chart_(chart), probe_(probe), cells_(cells) {}
  [[nodiscard]] SurfacePlace place() const {
    SurfacePlace out;
    dvec3 center(0.0);
    for (const std::size_t i : cells_) {
      const double area = grid_.cut->cells[i].total_area * static_cast<double>(shareAt(i));
      out.area += area;
      center += area * dvec3(pointAt(i));
    }
    if (out.area > 0.0) center /= out.area;
    const std::size_t middle = cellOf(center);
    // The middle lies between the fine cells' own points: a lamp's post there is news.
    if (isWhole(middle) && probe_.at(vec3(center)) == coverAt(middle) &&
        !probe_.inMatter(vec3(center))) {
      out.point = vec3(center);
      out.triangle = grid_.cut->cells[middle].triangle;
      return out;
    }
    // The middle is covered or off the chart.
    const std::size_t typical =
        grid_.outlook.empty() ? nearest(center) : typicalCell(grid_, cells_);
    out.point = pointAt(typical);
    out.triangle = grid_.cut->cells[typical].triangle;
    return out;
  }

 private:
  [[nodiscard]] std::size_t cellOf(const dvec3& p) const {
    const dvec3 d = p - dvec3(chart_.origin);
    const CellGrid& cut = *grid_.cut;
    const auto along = [&](const vec3& axis, float cell, int count) {
      const double x = glm::dot(d, dvec3(axis)) / static_cast<double>(cell);
      return std::clamp(static_cast<int>(x), 0, count - 1);
    };
    return static_cast<std::size_t>(along(chart_.b, cut.cell.y, cut.nv) * cut.nu +
                                    along(chart_.t, cut.cell.x, cut.nu));
  }
  [[nodiscard]] std::size_t nearest(const dvec3& p) const {
    return *std::min_element(cells_.begin(), cells_.end(), [&](std::size_t a, std::size_t b) {
      return glm::distance(dvec3(pointAt(a)), p) < glm::distance(dvec3(pointAt(b)), p);
    });
  }
  /// Whether the whole of a fine cell is surface of this texel.
  [[nodiscard]] bool isWhole(std::size_t i) const {
    const double full =
        static_cast<double>(grid_.cut->cell.x) * static_cast<double>(grid_.cut->cell.y);
    return std::find(cells_.begin(), cells_.end(), i) != cells_.end() && shareAt(i) == 1.0F &&
           grid_.cut->cells[i].area > 0.999 * full;
  }
  [[nodiscard]] Cover coverAt(std::size_t i) const {
    return grid_.outlook.empty() ? Cover::none : grid_.outlook[i].cover;
  }
  [[nodiscard]] float shareAt(std::size_t i) const {
    return grid_.outlook.empty() ? 1.0F : grid_.outlook[i].share;
  }
  [[nodiscard]] const vec3& pointAt(std::size_t i) const {
    return grid_.outlook.empty() ? grid_.cut->cells[i].point : grid_.outlook[i].point;
  }
  const SplitGrid& grid_;
  const Chart& chart_;
  const CoverProbe& probe_;
  std::span<const std::size_t> cells_;
};

/// Covered cells that nothing was counted for take the nearest texel's number: a ray that meets
/// them by rounding finds its light.
void spreadNumbers(const SplitGrid& grid, std::span<std::uint32_t> numbers) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] != kNoTexel) front.push_back(i);
  }
  const auto nu = static_cast<std::size_t>(grid.layout.nu);
  for (std::size_t k = 0; k < front.size(); ++k) {
    const std::size_t i = front[k];
    const auto visit = [&](bool inside, std::size_t to) {
      if (!inside || numbers[to] != kNoTexel || grid.cut->cells[to].area <= 0.0) return;
      numbers[to] = numbers[i];
      front.push_back(to);
    };
    visit(i % nu > 0, i - 1);
    visit(i % nu + 1 < nu, i + 1);
    visit(i >= nu, i - nu);
    visit(i + nu < numbers.size(), i + nu);
  }
}

void addPlanarSide(const Chart& chart, const SplitGrid& grid, const CoverProbe& probe, Draft& draft,
                   Texels& out) {
  const std::size_t base = out.cells.size();
  const std::size_t count = grid.cut->cells.size();
  out.cells.resize(base + count, kNoTexel);
  for (std::size_t i = 0; i < count; ++i) {
    draft.open.push_back(grid.outlook.empty() ? std::uint8_t{0} : grid.outlook[i].open);
  }
  std::vector<std::size_t> cells;
  for (std::size_t b = 0; b < grid.groups.size(); ++b) {
    out.split.push_back(grid.groups[b] > 1 ? 1 : 0);
    for (std::uint8_t group = 0; group < grid.groups[b]; ++group) {
      cells.clear();
      grid.forEachCell(b, [&](std::size_t i) {
        if (grid.exposed(i) && grid.cut->cells[i].owner == i && grid.group[i] == group) {
          cells.push_back(i);
        }
      });
      if (cells.empty()) continue;
      const SurfacePlace place = CellSum(grid, chart, probe, cells).place();
      const std::uint32_t texel =
          draft.add(place.point, probe.n, place.area, chart.material, place.triangle);
      for (const std::size_t i : cells) out.cells[base + i] = texel;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Cell& c = grid.cut->cells[i];
    if (c.area > 0.0 && c.owner != i) out.cells[base + i] = out.cells[base + c.owner];
  }
  spreadNumbers(grid, std::span(out.cells).subspan(base, count));
}

/// The cut grids of all planar charts, and on each side how finely.
struct Cutting {
  std::vector<CellGrid> cut;       ///< per chart
  std::vector<SplitGrid> grids;    ///< per lit side of planar charts
  std::vector<std::size_t> first;  ///< per chart, into grids
};

Cutting cutCharts(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
                  const Texels& texels, const geometry::RayCaster* caster) {
  const auto& charts = texels.charts.charts;
  Cutting out;
  out.cut.resize(charts.size());
  for (std::size_t c = 0; c < charts.size(); ++c) {
    out.first.push_back(out.grids.size());
    if (!charts[c].planar) continue;
    for (const Sides side : {kFront, kBack}) {
      if ((charts[c].sides & side) == 0) continue;
      SplitGrid grid;
      grid.layout = gridLayout(charts[c].size, texels.cell, caster != nullptr);
      grid.cut = &out.cut[c];
      grid.group.assign(
          static_cast<std::size_t>(grid.layout.nu) * static_cast<std::size_t>(grid.layout.nv), 0);
      grid.groups.assign(
          grid.group.size() / static_cast<std::size_t>(grid.layout.ku * grid.layout.kv), 1);
      out.grids.push_back(std::move(grid));
    }
  }
  out.first.push_back(out.grids.size());
  parallelFor(charts.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      if (out.first[c] == out.first[c + 1]) continue;
      const GridLayout& layout = out.grids[out.first[c]].layout;
      out.cut[c] = cutIntoCells(mesh, texels.charts, charts[c], layout.nu, layout.nv);
      if (caster == nullptr) continue;
      std::size_t g = out.first[c];
      for (const Sides side : {kFront, kBack}) {
        if ((charts[c].sides & side) == 0) continue;
        out.grids[g++].outlook =
            lookFromCells(mesh, sides, *caster, charts[c], out.cut[c], side == kFront,
                          static_cast<float>(Texels::kGapShare * texels.cell),
                          2.0F * static_cast<float>(texels.cell));
      }
    }
  });
  return out;
}

void addCurvedChart(const geometry::Mesh& mesh, std::span<const std::uint8_t> mesh_sides,
                    const Chart& chart, const geometry::RayCaster* caster, Draft& draft,
                    Texels& out) {
  const Charts& charts = out.charts;
  // The point: on the triangle whose centre is nearest to the chart's centre of area.
  dvec3 center(0.0);
  double area = 0.0;
  const auto triangleAt = [&](std::uint32_t k) {
    return charts.triangles[chart.first_triangle + k];
  };
  const auto corners = [&](std::uint32_t t) {
    const uvec3& i = mesh.triangles[t];
    return std::array<dvec3, 3>{dvec3(mesh.positions[i.x]), dvec3(mesh.positions[i.y]),
                                dvec3(mesh.positions[i.z])};
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
    SurfacePlace place{vec3(point), on, chart.area};
    if (caster != nullptr) {
      place = exposedPart(mesh, mesh_sides, *caster, charts, chart, place, n,
                          static_cast<float>(Texels::kGapShare * out.cell));
    }
    out.cells.push_back(place.area > 0.0
                            ? draft.add(place.point, n, place.area, chart.material, place.triangle)
                            : kNoTexel);
    out.split.push_back(0);
    draft.open.push_back(0);
  }
}

/// How wide a texel of this area is in texture coordinates, by the triangle's ratio of areas.
float uvWidth(const geometry::Mesh& mesh, std::uint32_t triangle, float area) {
  if (mesh.uvs.empty()) return 0.0F;
  const uvec3& t = mesh.triangles[triangle];
  const vec3 n = glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                            mesh.positions[t.z] - mesh.positions[t.x]);
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
                  const geometry::RayCaster* caster, std::size_t count, std::size_t* useful) {
  Texels out;
  out.cell = cell;
  // Charts of half a base cell are worth a grid of their own, as base cells may be split.
  out.charts = makeCharts(mesh, sides, caster == nullptr ? cell : kChartShare * cell);
  Cutting cutting = cutCharts(mesh, sides, out, caster);
  if (caster != nullptr) {
    std::size_t curved = 0;
    for (const Chart& chart : out.charts.charts)
      curved += chart.planar ? 0 : (chart.sides == kBothSides ? 2 : 1);
    const std::size_t splits = splitCells(cutting.grids, count - std::min(count, curved));
    if (useful != nullptr) *useful = splits;
  }
  Draft draft;
  for (std::size_t c = 0; c < out.charts.charts.size(); ++c) {
    const Chart& chart = out.charts.charts[c];
    Texels::Grid grid;
    grid.first = static_cast<std::uint32_t>(out.cells.size());
    grid.first_base = static_cast<std::uint32_t>(out.split.size());
    if (chart.planar && chart.sides != kNoSide) {
      const GridLayout& l = cutting.grids[cutting.first[c]].layout;
      grid.nu = l.nu;
      grid.nv = l.nv;
      grid.ku = l.ku;
      grid.kv = l.kv;
      grid.cell = cutting.cut[c].cell;
      std::size_t g = cutting.first[c];
      for (const Sides side : {kFront, kBack}) {
        if ((chart.sides & side) == 0) continue;
        const CoverProbe probe{mesh, sides, caster, side == kFront ? chart.normal : -chart.normal,
                               static_cast<float>(Texels::kGapShare * out.cell)};
        addPlanarSide(chart, cutting.grids[g++], probe, draft, out);
      }
    } else if (!chart.planar) {
      addCurvedChart(mesh, sides, chart, caster, draft, out);
    }
    out.grids.push_back(grid);
  }
  const Regions regions = findRegions(out, draft.open, draft.position, draft.normal, caster);
  if (caster != nullptr) out.links = std::move(draft.open);
  out.receivers = light::makeReceivers(draft.position, draft.normal, kClusterSize, regions.number);
  const std::size_t slots = out.receivers.slotCount();
  out.area.assign(slots, 0.0F);
  out.material.resize(slots);
  out.triangle.resize(slots);
  out.openness.resize(slots);
  out.part.resize(slots);
  out.uv.resize(slots);
  out.uv_width.resize(slots);
  for (std::size_t slot = 0; slot < slots; ++slot) {
    const std::uint32_t p = out.receivers.point_of[slot];
    if (out.receivers.slot_of[p] == slot) out.area[slot] = draft.area[p];
    out.material[slot] = draft.material[p];
    out.triangle[slot] = draft.triangle[p];
    out.openness[slot] = regions.openness[p];
    out.part[slot] = regions.part[p];
    out.uv[slot] = uvAt(mesh, draft.triangle[p], draft.position[p]);
    out.uv_width[slot] = uvWidth(mesh, draft.triangle[p], draft.area[p]);
  }
  for (std::uint32_t& c : out.cells) {
    if (c != kNoTexel) c = out.receivers.slot_of[c];
  }
  return out;
}

double cellForCount(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
                    std::size_t count, double least_cell) {
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const uvec3& t = mesh.triangles[i];
    const dvec3 a(mesh.positions[t.x]);
    const double twice =
        glm::length(glm::cross(dvec3(mesh.positions[t.y]) - a, dvec3(mesh.positions[t.z]) - a));
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
  while (cell > least_cell && makeTexels(mesh, sides, cell, nullptr).texelCount() < count)
    cell *= 0.985;
  return std::max(cell, least_cell);
}

}  // namespace soffit::transfer

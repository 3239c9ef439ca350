// SPDX-License-Identifier: MIT
#include "core/transfer/cell_outlook.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace soffit::transfer {
namespace {

/// Of a cell: when a ray meets a surface nearer than this share of its width, its middle lies on
/// that surface's foot. Direct light cannot tell there on which side of it a receiver is.
constexpr float kFoot = 0.1F;
constexpr float kFootMost = 4e-4F;  ///< m: such receivers are this near (direct_stage.h: epsilon)

/// Finds what covers cells.
class Places {
 public:
  Places(const geometry::Mesh& mesh, std::span<const std::uint8_t> sides,
         const geometry::RayCaster& caster, const Chart& chart, const CellGrid& cut, bool front,
         float gap)
      : mesh_(mesh), sides_(sides), caster_(caster), chart_(chart), cut_(cut), gap_(gap) {
    normal_ = front ? chart.normal : -chart.normal;
    full_ = 0.98 * static_cast<double>(cut.cell.x) * static_cast<double>(cut.cell.y);
  }

  void look(std::size_t i, CellOutlook& out) const {
    out.point = cut_.cells[i].point;
    out.cover = at(out.point);
    if (out.cover != Cover::none) lookAround(i, out);
  }

  /// The middle is known to be in matter after all.
  void lookPastMatter(std::size_t i, CellOutlook& out) const {
    out.cover = Cover::matter;
    lookAround(i, out);
  }

  /// The middle is covered, or too near to something that stands on the surface.
  void lookAround(std::size_t i, CellOutlook& out) const {
    if (cut_.cells[i].area < full_) return;
    std::array<vec3, 4> points;
    std::array<Cover, 4> covers{};
    std::array<int, 3> count{};
    count[static_cast<std::size_t>(out.cover)] = 1;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const float x = (k % 2 == 0 ? -0.35F : 0.35F) * cut_.cell.x;
      const float y = (k / 2 == 0 ? -0.35F : 0.35F) * cut_.cell.y;
      points[k] = out.point + x * chart_.t + y * chart_.b;
      covers[k] = at(points[k]);
      ++count[static_cast<std::size_t>(covers[k])];
    }
    if (count[0] == 0 && (out.cover == Cover::gap || count[1] == 0)) return;
    const Cover best = count[0] > 0 ? Cover::none : Cover::gap;
    const auto found = std::find(covers.begin(), covers.end(), best);
    if (found == covers.end()) return;  // none but the middle
    out.cover = best;
    out.share = static_cast<float>(count[static_cast<std::size_t>(best)]) / 5.0F;
    out.point = points[static_cast<std::size_t>(found - covers.begin())];
  }

 private:
  [[nodiscard]] Cover at(const vec3& p) const {
    return coverOf(mesh_, sides_, caster_, p, normal_, gap_);
  }

  const geometry::Mesh& mesh_;
  std::span<const std::uint8_t> sides_;
  const geometry::RayCaster& caster_;
  const Chart& chart_;
  const CellGrid& cut_;
  float gap_;
  vec3 normal_{0.0F};
  double full_ = 0.0;  ///< m^2 of a cell that no edge of the chart cuts
};

/// Rays from cell to cell just above the surface.
void findOpenings(const geometry::RayCaster& caster, const vec3& n, const CellGrid& cut,
                  std::span<CellOutlook> cells) {
  const float lift = 0.2F * std::max(cut.cell.x, cut.cell.y);
  const auto nu = static_cast<std::size_t>(cut.nu);
  parallelFor(cells.size(), 256, [&](std::size_t begin, std::size_t end) {
    std::vector<geometry::Ray> rays;
    std::vector<std::pair<std::size_t, std::uint8_t>> of;
    const auto usable = [&](std::size_t i) {
      return cut.cells[i].area > 0.0 && cells[i].cover != Cover::matter;
    };
    for (std::size_t i = begin; i < end; ++i) {
      if (!usable(i)) continue;
      const auto add = [&](std::size_t to, std::uint8_t bit) {
        if (!usable(to)) return;
        const vec3 from = cells[i].point + lift * n;
        rays.push_back({from, 0.0F, cells[to].point + lift * n - from, 1.0F});
        of.emplace_back(i, bit);
      };
      if (i % nu + 1 < nu) add(i + 1, std::uint8_t{1});
      if (i + nu < cells.size()) add(i + nu, std::uint8_t{2});
    }
    std::vector<std::uint8_t> blocked(rays.size(), 0);
    caster.occluded(rays, blocked);
    for (std::size_t r = 0; r < rays.size(); ++r) {
      if (blocked[r] == 0) cells[of[r].first].open |= of[r].second;
    }
  });
}

}  // namespace

std::vector<CellOutlook> lookFromCells(const geometry::Mesh& mesh,
                                       std::span<const std::uint8_t> sides,
                                       const geometry::RayCaster& caster, const Chart& chart,
                                       const CellGrid& cut, bool front, float gap, float scale) {
  const Places places(mesh, sides, caster, chart, cut, front, gap);
  const vec3 n = front ? chart.normal : -chart.normal;
  // The same directions for all cells: what differs then is the place.
  const auto directions = matterProbes(chart.t, chart.b, n);
  std::vector<CellOutlook> out(cut.cells.size());
  const float foot = std::min(kFootMost, kFoot * std::min(cut.cell.x, cut.cell.y));
  struct Seen {
    bool matter = false;
    bool foot = false;
  };
  const auto read = [&](std::span<const geometry::Hit> hits, CellOutlook& cell) {
    int inside = 0;
    Seen seen;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const bool met = hits[k].valid();
      const float share = met ? hits[k].t / (hits[k].t + scale) : 1.0F;
      cell.distance[k] = static_cast<std::uint8_t>(std::lround(255.0F * share));
      if (met && meetsInside(mesh, sides, hits[k].triangle, directions[k])) ++inside;
      seen.foot = seen.foot || (met && hits[k].t < foot);
    }
    seen.matter = inside > kMostInside;
    return seen;
  };
  parallelFor(out.size(), 256, [&](std::size_t begin, std::size_t end) {
    std::vector<geometry::Ray> rays;
    std::vector<std::size_t> of;
    const auto aim = [&](std::size_t i) {
      const vec3 origin = geometry::offsetOrigin(out[i].point, n);
      for (const vec3& d : directions) rays.push_back({origin, 0.0F, d});
    };
    for (std::size_t i = begin; i < end; ++i) {
      if (cut.cells[i].area <= 0.0) continue;
      places.look(i, out[i]);
      if (out[i].cover == Cover::matter) continue;
      of.push_back(i);
      aim(i);
    }
    std::vector<geometry::Hit> hits(rays.size());
    caster.closest(rays, hits);
    std::vector<std::size_t> again;
    for (std::size_t k = 0; k < of.size(); ++k) {
      const Seen seen = read({&hits[k * directions.size()], directions.size()}, out[of[k]]);
      if (!seen.matter && !seen.foot) continue;
      // One ray along the normal said otherwise: where a slab's end lies against a wall, it may
      // meet either of the two faces that coincide.
      if (seen.matter) {
        places.lookPastMatter(of[k], out[of[k]]);
      } else {
        places.lookAround(of[k], out[of[k]]);
      }
      if (out[of[k]].cover != Cover::matter) again.push_back(of[k]);
    }
    rays.clear();
    for (const std::size_t i : again) aim(i);
    hits.resize(rays.size());
    caster.closest(rays, hits);
    for (std::size_t k = 0; k < again.size(); ++k) {
      if (read({&hits[k * directions.size()], directions.size()}, out[again[k]]).matter) {
        out[again[k]].cover = Cover::matter;
      }
    }
  });
  findOpenings(caster, n, cut, out);
  return out;
}

}  // namespace soffit::transfer

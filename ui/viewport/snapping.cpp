// SPDX-License-Identifier: MIT
#include "ui/viewport/snapping.h"

#include "ui/viewport/gizmo.h"

#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kBelow = 0.03;

/// The nearest of the targets along one axis.
class Attraction {
 public:
  Attraction(double at, double reach) : at_(at), best_(reach) {}
  void offer(double target, std::vector<Snapped::Guide> guides) {
    const double d = std::abs(target - at_);
    if (d >= best_) return;
    best_ = d;
    target_ = target;
    found_ = true;
    guides_ = std::move(guides);
  }
  [[nodiscard]] bool found() const { return found_; }
  [[nodiscard]] double target() const { return target_; }
  [[nodiscard]] const std::vector<Snapped::Guide>& guides() const { return guides_; }

 private:
  double at_;
  double best_;
  double target_ = 0.0;
  bool found_ = false;
  std::vector<Snapped::Guide> guides_;
};

/// A wall on either side of a place.
struct Walls {
  std::optional<double> low;
  std::optional<double> high;
};

Walls wallsAlong(const Surroundings& around, const dvec3& place, int axis) {
  const dvec3 from(place.x, place.y, place.z - kBelow);
  Walls walls;
  if (const auto d = around.distance(from, -axisOf(axis))) walls.low = place[axis] - *d;
  if (const auto d = around.distance(from, axisOf(axis))) walls.high = place[axis] + *d;
  return walls;
}

dvec3 with(dvec3 p, int axis, double value) {
  p[axis] = value;
  return p;
}

void offerAxes(const Surroundings& around, const dvec3& place, int axis, Attraction& pull) {
  for (const Surroundings::Neighbour& n : around.neighbours) {
    if (axis < 2 && std::abs(n.place.z - place.z) > 0.5) continue;
    const dvec3 aligned = with(place, axis, n.place[axis]);
    if (std::abs(n.place[axis] - place[axis]) < 0.5 &&
        around.sees(n.place - dvec3(0, 0, kBelow), aligned - dvec3(0, 0, kBelow))) {
      pull.offer(n.place[axis], {{n.place, aligned}});
    }
  }
}

void offerSpacing(const Surroundings& around, const dvec3& place, int axis, const Walls& walls,
                  Attraction& pull) {
  const std::vector<double> row = rowThrough(around, place, axis);
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    const double step = row[i + 1] - row[i];
    const dvec3 a = with(place, axis, row[i]);
    const dvec3 b = with(place, axis, row[i + 1]);
    pull.offer(row[i] - step, {{with(place, axis, row[i] - step), a}, {a, b}});
    pull.offer(row[i + 1] + step, {{a, b}, {b, with(place, axis, row[i + 1] + step)}});
    const double middle = 0.5 * (row[i] + row[i + 1]);
    pull.offer(middle, {{a, with(place, axis, middle)}, {with(place, axis, middle), b}});
  }
  // With one wall and one neighbour: a third of the way makes the wall's share half a spacing.
  const auto share = [&](std::optional<double> wall, double next) {
    if (!wall) return;
    const double at = *wall + (next - *wall) / 3.0;
    pull.offer(at, {{with(place, axis, *wall), with(place, axis, at)},
                    {with(place, axis, at), with(place, axis, next)}});
  };
  if (!row.empty()) {
    share(walls.low, row.front());
    share(walls.high, row.back());
  }
}

void offerWalls(const dvec3& place, int axis, const Walls& walls, double half, Attraction& pull) {
  if (walls.low) {
    const dvec3 wall = with(place, axis, *walls.low);
    pull.offer(*walls.low + half, {{wall, with(place, axis, *walls.low + half)}});
  }
  if (walls.high) {
    const dvec3 wall = with(place, axis, *walls.high);
    pull.offer(*walls.high - half, {{with(place, axis, *walls.high - half), wall}});
  }
  if (walls.low && walls.high) {
    pull.offer(0.5 * (*walls.low + *walls.high),
               {{with(place, axis, *walls.low), with(place, axis, *walls.high)}});
  }
}

void offerCeiling(const Surroundings& around, const dvec3& place, double half, double reach,
                  Attraction& pull) {
  // From below, for the place may be above the ceiling already.
  const dvec3 from(place.x, place.y, place.z - half - 2.0 * reach);
  const auto up = around.distance(from, axisOf(2));
  if (!up) return;
  const double ceiling = from.z + *up;
  pull.offer(ceiling - kCeilingGap - half,
             {{with(place, 2, ceiling - kCeilingGap - half), with(place, 2, ceiling)}});
}

Attraction pullAlong(const Surroundings& around, const SnapRules& rules, const dvec3& place,
                     int axis, double half_size, double reach) {
  Attraction pull(place[axis], reach);
  if (rules.luminaires) offerAxes(around, place, axis, pull);
  if (axis == 2) {
    if (rules.surfaces) offerCeiling(around, place, half_size, reach, pull);
    return pull;
  }
  const Walls walls = wallsAlong(around, place, axis);
  if (rules.luminaires) offerSpacing(around, place, axis, walls, pull);
  if (rules.surfaces) offerWalls(place, axis, walls, half_size, pull);
  return pull;
}

}  // namespace

Snapped snap(const Surroundings& around, const SnapRules& rules, const dvec3& place,
             const glm::bvec3& axes, const dvec3& half_size, double reach) {
  Snapped out;
  out.place = place;
  glm::bvec3 found(false);
  // Twice: a place that was drawn into a row by one axis finds the row's spacing along the other.
  for (int pass = 0; pass < 2; ++pass) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!axes[axis] || found[axis]) continue;
      const Attraction pull = pullAlong(around, rules, out.place, axis, half_size[axis], reach);
      if (!pull.found()) continue;
      found[axis] = true;
      out.place[axis] = pull.target();
      out.guides.insert(out.guides.end(), pull.guides().begin(), pull.guides().end());
    }
  }
  if (!rules.grid || rules.grid_step <= 0.0) return out;
  for (int axis = 0; axis < 3; ++axis) {
    if (!axes[axis] || found[axis]) continue;
    out.place[axis] = rules.grid_step * std::round(out.place[axis] / rules.grid_step);
  }
  return out;
}

}  // namespace soffit::ui

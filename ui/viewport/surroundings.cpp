// SPDX-License-Identifier: MIT
#include "ui/viewport/surroundings.h"

#include "ui/viewport/gizmo.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

/// Rays start this much below a place: a panel lies in its ceiling.
constexpr double kBelow = 0.03;
constexpr double kFarthest = 60.0;  // m; beyond, nobody measures by eye

dvec3 below(const dvec3& p) {
  return {p.x, p.y, p.z - kBelow};
}

}  // namespace

std::optional<double> Surroundings::distance(const dvec3& from, const dvec3& direction) const {
  if (caster == nullptr) return std::nullopt;
  geometry::Ray ray;
  ray.origin = vec3(from - origin);
  ray.direction = vec3(direction);
  ray.t_max = static_cast<float>(kFarthest);
  const geometry::Hit hit = caster->closest(ray);
  if (!hit.valid()) return std::nullopt;
  return static_cast<double>(hit.t);
}

bool Surroundings::sees(const dvec3& from, const dvec3& to) const {
  if (caster == nullptr) return true;
  const double length = glm::length(to - from);
  if (length < 1e-6) return true;
  const auto hit = distance(from, (to - from) / length);
  return !hit || *hit >= length - 1e-3;
}

std::vector<double> rowThrough(const Surroundings& around, const dvec3& place, int axis) {
  std::vector<double> row;
  const int across = 1 - axis;
  for (const Surroundings::Neighbour& n : around.neighbours) {
    if (std::abs(n.place[across] - place[across]) > kRowWidth) continue;
    if (std::abs(n.place.z - place.z) > 0.5) continue;
    if (!around.sees(below(place), below(n.place))) continue;
    row.push_back(n.place[axis]);
  }
  std::ranges::sort(row);
  // What lies in one place is one.
  const auto same = [](double a, double b) { return std::abs(a - b) < 1e-3; };
  row.erase(std::unique(row.begin(), row.end(), same), row.end());
  return row;
}

std::vector<Clearance> clearances(const Surroundings& around, const dvec3& place,
                                  const glm::bvec3& axes) {
  std::vector<Clearance> all;
  for (int axis = 0; axis < 3; ++axis) {
    if (!axes[axis]) continue;
    const std::vector<double> row =
        axis < 2 ? rowThrough(around, place, axis) : std::vector<double>{};
    for (const double way : {-1.0, 1.0}) {
      const dvec3 direction = way * axisOf(axis);
      const auto wall = around.distance(axis < 2 ? below(place) : place, direction);
      double nearest = wall.value_or(kFarthest);
      bool is_wall = wall.has_value();
      for (const double at : row) {
        const double d = way * (at - place[axis]);
        if (d < 1e-3 || d > nearest) continue;
        nearest = d;
        is_wall = false;
      }
      if (nearest < kFarthest && nearest > 1e-3) {
        all.push_back({place, place + nearest * direction, is_wall});
      }
    }
  }
  return all;
}

}  // namespace soffit::ui

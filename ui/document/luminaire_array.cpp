// SPDX-License-Identifier: MIT
#include "ui/document/luminaire_array.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

/// One side of an array: places along an axis.
struct Side {
  int count = 1;
  double spacing = 0.0;
  double first = 0.0;
};

Side planSide(int count, double spacing, double lo, double hi, double size) {
  const double length = std::max(hi - lo, 1e-6);
  Side side;
  const int most = std::max(1, static_cast<int>(std::floor(length / std::max(size, 1e-3) + 1e-9)));
  side.count = std::clamp(count, 1, std::min(most, kMostPerSide));
  const double automatic = length / side.count;
  side.spacing = spacing > 0.0 ? spacing : automatic;
  if (side.count > 1) {
    const double widest = std::max((length - size) / (side.count - 1), 0.0);
    side.spacing = std::clamp(side.spacing, std::min(size, widest), widest);
  }
  side.first = 0.5 * (lo + hi) - 0.5 * (side.count - 1) * side.spacing;
  return side;
}

ArrayPlan planCircle(const ArraySettings& wanted, const ArrayField& field, const dvec2& size) {
  ArrayPlan plan;
  plan.settings = wanted;
  const dvec2 center = 0.5 * (field.lo + field.hi);
  const double own = 0.5 * glm::length(size);
  const double room = 0.5 * std::min(field.hi.x - field.lo.x, field.hi.y - field.lo.y);
  const double most = std::max(room - own, 0.0);
  plan.settings.radius = std::clamp(wanted.radius > 0.0 ? wanted.radius : 0.5 * room, 0.0, most);
  plan.settings.columns = std::clamp(wanted.columns, 1, kMostPerSide);
  for (int i = 0; i < plan.settings.columns; ++i) {
    const double phi = 2.0 * kPi * i / plan.settings.columns;
    plan.places.push_back(center + plan.settings.radius * dvec2(std::cos(phi), std::sin(phi)));
    plan.turn_deg.push_back(degrees(phi));
  }
  plan.wall_distance = dvec2(room - plan.settings.radius);
  return plan;
}

}  // namespace

ArrayPlan planArray(const ArraySettings& wanted, const ArrayField& field, const dvec2& size) {
  if (wanted.kind == ArrayKind::circle) return planCircle(wanted, field, size);
  ArrayPlan plan;
  plan.settings = wanted;
  Side x = planSide(wanted.columns, wanted.spacing.x, field.lo.x, field.hi.x, size.x);
  // A line has one count, whichever way it runs.
  const int rows = wanted.kind == ArrayKind::line_y ? wanted.columns : wanted.rows;
  Side y = planSide(rows, wanted.spacing.y, field.lo.y, field.hi.y, size.y);
  if (wanted.kind == ArrayKind::line_x) y = {1, 0.0, field.through.y};
  if (wanted.kind == ArrayKind::line_y) {
    x = {1, 0.0, field.through.x};
    plan.settings.columns = y.count;
  } else {
    plan.settings.columns = x.count;
    plan.settings.rows = y.count;
  }
  plan.settings.spacing = {x.spacing, y.spacing};
  plan.wall_distance = {x.first - field.lo.x, y.first - field.lo.y};
  for (int j = 0; j < y.count; ++j) {
    for (int i = 0; i < x.count; ++i) {
      plan.places.emplace_back(x.first + i * x.spacing, y.first + j * y.spacing);
      plan.turn_deg.push_back(0.0);
    }
  }
  return plan;
}

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/surroundings.h"

#include <vector>

namespace soffit::ui {

/// What luminaires snap to while they are moved or placed.
struct SnapRules {
  bool surfaces = true;    ///< ceiling, walls, the middle between walls
  bool luminaires = true;  ///< axes of others, and their spacing carried on
  bool grid = false;       ///< whole steps of `grid_step`, where nothing else attracts
  double grid_step = 0.1;  ///< m
};

/// A place that was attracted, and the lines that say by what.
struct Snapped {
  dvec3 place{0.0};
  struct Guide {
    dvec3 from{0.0};
    dvec3 to{0.0};
  };
  std::vector<Guide> guides;
};

/// Attracts a place along each axis by itself.
///
/// axes       along which it may move.
/// half_size  of what is placed, m, world axes: its edge meets a wall, its top keeps
///            kCeilingGap from the ceiling.
/// reach      m; targets further away do not attract. 0: nothing but the grid.
///
/// Targets: x and y of other luminaires in sight; their spacing carried on beyond the ends of the
/// row, halved inside it; half of that spacing from a wall; the middle between two walls; a wall.
/// Along z the ceiling, and the height of others. The nearest wins.
Snapped snap(const Surroundings& around, const SnapRules& rules, const dvec3& place,
             const glm::bvec3& axes, const dvec3& half_size, double reach);

/// Luminaires in a ceiling hang so much below it, m: light needs room to leave.
inline constexpr double kCeilingGap = 0.01;

}  // namespace soffit::ui

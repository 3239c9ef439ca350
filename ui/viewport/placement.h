// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/luminaire_types.h"
#include "ui/viewport/pointing.h"
#include "ui/viewport/snapping.h"

#include <optional>

namespace soffit::ui {

/// How a place is found while something is placed.
struct PlacementRules {
  SnapRules snap;
  double reach = 0.0;     ///< m, of snapping; 0: none
  double turn_deg = 0.0;  ///< about the vertical, or about the wall's normal
};

/// A luminaire of a kind where a surface is pointed at.
struct Placement {
  light::Luminaire luminaire;
  std::vector<Snapped::Guide> guides;
  std::vector<Clearance> clearances;
};

/// Pointed at a ceiling it hangs there; at a floor or a desk, from the ceiling above it, or 2.5 m
/// above it where there is none; at a wall, on the wall, shining away from it.
/// Nothing when the luminaire cannot be made (its shape is degenerate).
std::optional<Placement> placeOn(const LuminaireType& type, const SurfaceReading& surface,
                                 const Surroundings& around, const PlacementRules& rules);

/// The height of the ceiling above a place, world z; nothing under the open sky.
std::optional<double> ceilingAbove(const Surroundings& around, const dvec3& place);

}  // namespace soffit::ui

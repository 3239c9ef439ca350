// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/math/vec.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soffit::ui {

/// What a luminaire is held against while it is placed: the surfaces around it and the other
/// luminaires. World coordinates, metres.
struct Surroundings {
  /// A luminaire that stays where it is.
  struct Neighbour {
    std::string name;
    dvec3 place{0.0};
  };

  /// Keeps a caster alive as long as it is used; null: no surfaces are known yet.
  std::shared_ptr<const void> owner;
  const geometry::RayCaster* caster = nullptr;
  dvec3 origin{0.0};  ///< of the caster's coordinates
  std::vector<Neighbour> neighbours;

  /// Metres from a place to the first surface in a world direction (unit); nothing without one.
  [[nodiscard]] std::optional<double> distance(const dvec3& from, const dvec3& direction) const;
  /// Whether nothing lies between two places.
  [[nodiscard]] bool sees(const dvec3& from, const dvec3& to) const;
};

/// Luminaires are in one row when they are off its line by less than this, m.
inline constexpr double kRowWidth = 0.05;

/// Places of the neighbours in the row through `place` along a world axis (0, 1), ascending; those
/// behind walls are left out.
std::vector<double> rowThrough(const Surroundings& around, const dvec3& place, int axis);

/// A distance to show: from a place to the wall or the neighbour next to it.
struct Clearance {
  dvec3 from{0.0};
  dvec3 to{0.0};
  bool wall = false;
};

/// From a place along both ways of each horizontal axis that is given, to what comes first there,
/// a neighbour in the row or a wall; along z to floor and ceiling.
std::vector<Clearance> clearances(const Surroundings& around, const dvec3& place,
                                  const glm::bvec3& axes);

}  // namespace soffit::ui

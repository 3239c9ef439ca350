// SPDX-License-Identifier: MIT
#pragma once

#include "core/daylight/environment.h"
#include "core/daylight/panes.h"
#include "core/math/vec.h"

#include <span>
#include <vector>

namespace soffit::reference {

/// Draws directions toward the surroundings for a receiver: half of them in proportion to the
/// surroundings' luminance, half toward the panes, through which a room sees them (all in
/// proportion to luminance where there is no glass).
class SkyChoice {
 public:
  struct Drawn {
    dvec3 direction{0.0};
    double density = 0.0;  ///< per steradian; 0: nothing was drawn
  };

  /// environment outlives this; panes may be null.
  SkyChoice(const daylight::Environment& environment, const daylight::Panes* panes,
            const geometry::Mesh& mesh);

  /// u in [0, 1)^3.
  [[nodiscard]] Drawn draw(const dvec3& y, const dvec3& u) const;
  /// The density that draw() has at a direction.
  [[nodiscard]] double density(const dvec3& y, const dvec3& direction) const;

 private:
  [[nodiscard]] double paneDensity(const dvec3& y, const dvec3& direction) const;

  const daylight::Environment& environment_;
  const daylight::Panes* panes_;
  const geometry::Mesh& mesh_;
  std::vector<double> areas_;  ///< running sums over the panes' triangles
};

}  // namespace soffit::reference

// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/sh/sphere_samples.h"

#include <optional>

/// How pictures of the surroundings are laid out: which direction a pixel shows.
///
/// Picture coordinates s = 0 .. 1 to the right and t = 0 .. 1 downwards. In every layout the centre
/// looks to +y with +z up and +x to the right (interfaces.md, Sky), so the same surroundings in two
/// layouts give the same light.
namespace soffit::sh {

enum class EnvironmentLayout {
  lat_long,          ///< 2:1, +z along the top edge, columns run clockwise seen from above
  angular_map,       ///< 1:1, Debevec's light probe: the angle from +y is pi times the radius
  horizontal_cross,  ///< 4:3: -x, +y, +x, -y in the middle row; +z above, -z below +y
  vertical_cross,    ///< 3:4: +z, +y, -z, -y (upside down) in the middle column; -x left, +x right
};

/// The unit direction at (s, t); nothing outside the disk of an angular map or the squares of a
/// cross.
std::optional<dvec3> environmentDirection(EnvironmentLayout layout, const dvec2& st);

/// The (s, t) that shows a direction (any length above 0). At a lat-long's poles any s would do; at
/// the rim of an angular map, direction -y, the point on the right is taken.
dvec2 environmentPoint(EnvironmentLayout layout, const dvec3& direction);

/// The pixels of a width x height picture in memory order (row by row from the top), each with the
/// direction of its centre and its solid angle; pixels that show nothing have weight 0 and the
/// direction +y. Exact per pixel for lat-longs and crosses whose squares hold whole pixels; else
/// by the midpoint rule, scaled to the sum of 4 pi. width, height >= 1.
SphereSamples environmentSamples(EnvironmentLayout layout, int width, int height);

}  // namespace soffit::sh

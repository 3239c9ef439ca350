// SPDX-License-Identifier: MIT
#pragma once

#include "core/design/contours.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Lines of equal value about nothing: where light is even and near a level, its error alone
/// crosses the level here and there, and each crossing is a tiny loop.
namespace soffit::design {

/// Which points of a field lie next to one another.
struct Neighbours {
  std::vector<std::uint32_t> first;  ///< those of point i are to[first[i]] .. to[first[i + 1]]
  std::vector<std::uint32_t> to;
  std::vector<std::uint8_t> border;  ///< the field ends there: what lies beyond is not known
};

/// Of a triangle mesh: points that share an edge. An edge that one triangle has alone is the
/// border.
Neighbours meshNeighbours(std::size_t vertices, std::span<const std::uint32_t> indices);

/// When a set of connected points above (or below) a level is a speck.
struct SpeckRule {
  double error = 0.01;    ///< none of them is farther from the level than this share of it
  std::size_t most = 16;  ///< nor are they more than these: a cluster of 4 x 4 texels
};

/// A point of a speck and the value that takes it to the side of those around it.
struct FlattenedPoint {
  std::uint32_t point = 0;
  float value = 0.0F;
};

/// The points of all specks, level by level. With these values the loops about specks are gone, and
/// all other lines of contoursAt() are the same bit for bit: no edge that one of them crosses has
/// an end in a speck. No value changes by more than 2 error * level.
///
/// A set that is larger, deeper or at the border is no speck: a real spot of light, however small,
/// differs from its surroundings by more than the error of the light, and what is wide is seen.
/// values: one per point, >= 0. levels: any order, > 0.
std::vector<FlattenedPoint> findSpecks(std::span<const float> values, const Neighbours& neighbours,
                                       std::span<const double> levels, const SpeckRule& rule = {});

/// The lines of contoursAt() but those that go round specks; the others as they are.
/// values: of the grid, nu points to a row.
std::vector<Contour> withoutSpecks(std::vector<Contour> lines, std::span<const double> values,
                                   int nu, double level, const SpeckRule& rule = {});

}  // namespace soffit::design

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/math/box.h"
#include "core/math/vec.h"

/// Which vertices are the same point.
///
/// Files repeat a point for each face, normal or object, and transforms shift the copies by a
/// rounding or two; topology (edges, components) needs one number per point.
namespace soffit::geometry {

/// The distance in metres below which two points of a model are one: two units in the last place
/// of the largest coordinate in single precision, 2^-22 of it (2.4 micrometres at 10 m).
float weldTolerance(const Box& bounds);

/// For each position the index of the first position it coincides with (itself, if it is the
/// first). Positions chain to a representative at most `tolerance` away, never to one another's
/// neighbors, so nothing drifts. tolerance 0 welds equal coordinates only. Positions that are not
/// finite stay alone. O(n), same result for any thread count.
std::vector<std::uint32_t> weldPositions(std::span<const vec3> positions, float tolerance);

}  // namespace soffit::geometry

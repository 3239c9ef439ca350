// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/sh/sphere_samples.h"

#include <array>

/// Cube maps: frames of the faces, directions and exact solid angles of their texels.
///
/// Each face covers 90 degrees (the 45 degrees of Fujita & Kanai are the half angle). On a face,
/// column i runs to its right, row j downwards, both from 0; u = -1 .. 1 to the right, v = -1 .. 1
/// downwards; the direction is forward + u right - v up, normalised. A texel's place in memory is
/// (face * n + row) * n + column.
namespace soffit::sh {

struct CubeFace {
  dvec3 forward, right, up;  ///< right-handed as a camera: right x up = -forward
};

/// Order +x, -x, +y, -y, +z, -z. The four side faces have +z up; +z and -z continue the face +y
/// above and below (as in a horizontal cross around +y).
inline constexpr std::array<CubeFace, 6> kCubeFaces{{
    {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
    {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
    {{0, -1, 0}, {-1, 0, 0}, {0, 0, 1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
    {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}},
}};

/// A place on a cube map: u, v in [-1, 1].
struct CubePoint {
  int face = 0;
  double u = 0.0, v = 0.0;
};

/// Unit direction of a place; u and v may lie beyond the face by any amount.
dvec3 cubeDirection(const CubePoint& point);

/// The place that a direction (any length above 0) goes through; on an edge one of its faces.
CubePoint cubePoint(const dvec3& direction);

/// Centre of texel (column, row) of a face of n x n texels.
CubePoint texelCenter(int face, int column, int row, int n);

/// Index of the texel of an n x n x 6 map that a direction falls into.
std::size_t texelOf(const dvec3& direction, int n);

/// Solid angle of the rectangle [u0, u1] x [v0, v1] of a face, steradians: differences of
/// atan2(u v, sqrt(u^2 + v^2 + 1)); exact, in double because it cancels for small texels.
double rectangleSolidAngle(double u0, double v0, double u1, double v1);

/// The texels of an n x n x 6 cube map in memory order with their exact solid angles, n >= 1; the
/// weights sum to 4 pi. (Fujita & Kanai's weights 1/sqrt(x^2+y^2+1) lose 20.7 % of the sphere.)
SphereSamples cubeSamples(int n);

}  // namespace soffit::sh

// SPDX-License-Identifier: MIT
#include "core/sh/cube_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::sh {
namespace {

/// Solid angle of the rectangle from the face's centre to (u, v), with the sign of u v.
double cornerAngle(double u, double v) {
  return std::atan2(u * v, std::sqrt(u * u + v * v + 1.0));
}

int texelIndex(double u, int n) {
  return std::clamp(static_cast<int>(std::floor(0.5 * (u + 1.0) * n)), 0, n - 1);
}

}  // namespace

dvec3 cubeDirection(const CubePoint& point) {
  const CubeFace& face = kCubeFaces.at(static_cast<std::size_t>(point.face));
  return glm::normalize(face.forward + point.u * face.right - point.v * face.up);
}

CubePoint cubePoint(const dvec3& direction) {
  const dvec3 size = glm::abs(direction);
  CubePoint point;
  if (size.x >= size.y && size.x >= size.z) {
    point.face = direction.x >= 0.0 ? 0 : 1;
  } else if (size.y >= size.z) {
    point.face = direction.y >= 0.0 ? 2 : 3;
  } else {
    point.face = direction.z >= 0.0 ? 4 : 5;
  }
  const CubeFace& face = kCubeFaces[static_cast<std::size_t>(point.face)];
  const double depth = glm::dot(direction, face.forward);
  point.u = glm::dot(direction, face.right) / depth;
  point.v = -glm::dot(direction, face.up) / depth;
  return point;
}

CubePoint texelCenter(int face, int column, int row, int n) {
  return {face, (2.0 * column + 1.0) / n - 1.0, (2.0 * row + 1.0) / n - 1.0};
}

std::size_t texelOf(const dvec3& direction, int n) {
  const CubePoint p = cubePoint(direction);
  return static_cast<std::size_t>((p.face * n + texelIndex(p.v, n)) * n + texelIndex(p.u, n));
}

double rectangleSolidAngle(double u0, double v0, double u1, double v1) {
  return cornerAngle(u1, v1) - cornerAngle(u0, v1) - cornerAngle(u1, v0) + cornerAngle(u0, v0);
}

SphereSamples cubeSamples(int n) {
  assert(n >= 1);
  SphereSamples samples;
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        const CubePoint center = texelCenter(face, column, row, n);
        const double half = 1.0 / n;
        samples.add(cubeDirection(center), rectangleSolidAngle(center.u - half, center.v - half,
                                                               center.u + half, center.v + half));
      }
    }
  }
  return samples;
}

}  // namespace soffit::sh

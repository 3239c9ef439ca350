// SPDX-License-Identifier: MIT
#include "core/sh/environment_layout.h"

#include "core/sh/cube_map.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace soffit::sh {
namespace {

/// Which face of the cube a square of a cross shows; turned: by 180 degrees.
struct CrossSquare {
  int column, row, face;
  bool turned;
};

struct Cross {
  int columns, rows;
  std::array<CrossSquare, 6> squares;
};

constexpr Cross kHorizontal{4,
                            3,
                            {{{2, 1, 0, false},
                              {0, 1, 1, false},
                              {1, 1, 2, false},
                              {3, 1, 3, false},
                              {1, 0, 4, false},
                              {1, 2, 5, false}}}};
constexpr Cross kVertical{3,
                          4,
                          {{{2, 1, 0, false},
                            {0, 1, 1, false},
                            {1, 1, 2, false},
                            {1, 3, 3, true},
                            {1, 0, 4, false},
                            {1, 2, 5, false}}}};

const Cross& crossOf(EnvironmentLayout layout) {
  return layout == EnvironmentLayout::horizontal_cross ? kHorizontal : kVertical;
}

dvec3 latLongDirection(const dvec2& st) {
  const double phi = 2.0 * kPi * (st.x - 0.5);  // clockwise from +y
  const double theta = kPi * st.y;
  return {std::sin(theta) * std::sin(phi), std::sin(theta) * std::cos(phi), std::cos(theta)};
}

std::optional<dvec3> angularDirection(const dvec2& st) {
  const double x = 2.0 * st.x - 1.0;
  const double z = 1.0 - 2.0 * st.y;
  const double r = std::hypot(x, z);
  if (r > 1.0) return std::nullopt;
  // sin(pi r)/r, whose limit at the centre is pi.
  const double across = r > 1e-9 ? std::sin(kPi * r) / r : kPi;
  return dvec3(x * across, std::cos(kPi * r), z * across);
}

/// Where (s, t) falls on the cube.
std::optional<CubePoint> crossPoint(const Cross& cross, const dvec2& st) {
  const double x = st.x * cross.columns;
  const double y = st.y * cross.rows;
  for (const CrossSquare& square : cross.squares) {
    const double u = 2.0 * (x - square.column) - 1.0;
    const double v = 2.0 * (y - square.row) - 1.0;
    if (std::abs(u) > 1.0 || std::abs(v) > 1.0) continue;
    return square.turned ? CubePoint{square.face, -u, -v} : CubePoint{square.face, u, v};
  }
  return std::nullopt;
}

/// Solid angle of a pixel of half width `half` (in s, t) per square of s, t, or its exact whole.
double pixelAngle(EnvironmentLayout layout, const dvec2& st, const dvec2& half) {
  switch (layout) {
    case EnvironmentLayout::lat_long:
      return 4.0 * kPi * half.x *
             (std::cos(kPi * (st.y - half.y)) - std::cos(kPi * (st.y + half.y)));
    case EnvironmentLayout::angular_map: {
      const double r = std::hypot(2.0 * st.x - 1.0, 2.0 * st.y - 1.0);
      const double across = r > 1e-9 ? std::sin(kPi * r) / r : kPi;
      return across;  // d omega = sin(pi r) pi dr dphi and the area is r dr dphi
    }
    default: {
      const Cross& cross = crossOf(layout);
      const auto point = crossPoint(cross, st);
      if (!point) return 0.0;
      const double u = 2.0 * half.x * cross.columns;
      const double v = 2.0 * half.y * cross.rows;
      return rectangleSolidAngle(point->u - u, point->v - v, point->u + u, point->v + v);
    }
  }
}

}  // namespace

std::optional<dvec3> environmentDirection(EnvironmentLayout layout, const dvec2& st) {
  if (layout == EnvironmentLayout::lat_long) return latLongDirection(st);
  if (layout == EnvironmentLayout::angular_map) return angularDirection(st);
  const auto point = crossPoint(crossOf(layout), st);
  if (!point) return std::nullopt;
  return cubeDirection(*point);
}

dvec2 environmentPoint(EnvironmentLayout layout, const dvec3& direction) {
  const double across = std::hypot(direction.x, direction.z);
  if (layout == EnvironmentLayout::lat_long) {
    const double theta = std::atan2(std::hypot(direction.x, direction.y), direction.z);
    return {0.5 + std::atan2(direction.x, direction.y) / (2.0 * kPi), theta / kPi};
  }
  if (layout == EnvironmentLayout::angular_map) {
    const double r = std::atan2(across, direction.y) / kPi;
    const dvec2 way = across > 0.0 ? dvec2(direction.x, direction.z) / across : dvec2(1.0, 0.0);
    return {0.5 + 0.5 * r * way.x, 0.5 - 0.5 * r * way.y};
  }
  const Cross& cross = crossOf(layout);
  const CubePoint point = cubePoint(direction);
  const auto square = std::find_if(cross.squares.begin(), cross.squares.end(),
                                   [&](const CrossSquare& s) { return s.face == point.face; });
  const double turn = square->turned ? -1.0 : 1.0;
  return {(square->column + 0.5 + 0.5 * turn * point.u) / cross.columns,
          (square->row + 0.5 + 0.5 * turn * point.v) / cross.rows};
}

SphereSamples environmentSamples(EnvironmentLayout layout, int width, int height) {
  assert(width >= 1 && height >= 1);
  SphereSamples samples;
  const dvec2 half(0.5 / width, 0.5 / height);
  double sum = 0.0;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const dvec2 st((column + 0.5) / width, (row + 0.5) / height);
      const auto direction = environmentDirection(layout, st);
      const double angle = direction ? pixelAngle(layout, st, half) : 0.0;
      samples.add(direction.value_or(dvec3(0, 1, 0)), angle);
      sum += angle;
    }
  }
  if (sum <= 0.0) return samples;  // a picture too small to show anything
  for (double& weight : samples.weights) weight *= 4.0 * kPi / sum;
  return samples;
}

}  // namespace soffit::sh

// SPDX-License-Identifier: MIT
#include "core/glossy/parallax.h"

#include "core/sh/cube_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace soffit::glossy {

Lookup seenFrom(const vec3& probe, const vec3& p, const vec3& d, float t) {
  const vec3 from_probe = p + t * d - probe;
  const float distance = glm::length(from_probe);
  if (!(distance > 1.0e-6F)) return {d, 1.0F};
  return {from_probe / distance, t / distance};
}

std::optional<float> distanceToBox(const Box& box, const vec3& p, const vec3& d) {
  float nearest = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const float low = box.lo[axis];
    const float high = box.hi[axis];
    const float slack = 1.0e-3F;  // receivers lie in the walls
    if (p[axis] < low - slack || p[axis] > high + slack) return std::nullopt;
    if (d[axis] == 0.0F) continue;
    const float wall = d[axis] > 0.0F ? high : low;
    nearest = std::min(nearest, std::max(0.0F, (wall - p[axis]) / d[axis]));
  }
  return nearest;
}

Lookup throughBox(const Box& room, const vec3& probe, const vec3& p, const vec3& d) {
  const auto t = distanceToBox(room, p, d);
  if (!t || !std::isfinite(*t)) return {d, 1.0F};
  return seenFrom(probe, p, d, *t);
}

ProbeDepth::ProbeDepth(int side, std::span<const float> distances) : side_(side) {
  const auto wide = static_cast<std::size_t>(side) + 2;
  assert(distances.size() == 6 * static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  inverse_.resize(6 * wide * wide);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        const sh::CubePoint p = sh::texelCenter(face, column, row, side);
        const float t = distances[static_cast<std::size_t>((face * side + row) * side + column)];
        // Nothing there, 1 / infinity, is 0.
        at(face, row, column) =
            static_cast<float>(std::sqrt(1.0 + p.u * p.u + p.v * p.v)) / std::max(t, 1.0e-6F);
      }
    }
  }
  // Just beyond an edge lies what the neighbour sees there, measured before this face.
  const double inner = side - 1.0;
  for (int face = 0; face < 6; ++face) {
    for (int row = -1; row <= side; ++row) {
      for (int column = -1; column <= side; ++column) {
        const bool beyond_u = column < 0 || column == side;
        const bool beyond_v = row < 0 || row == side;
        if (!beyond_u && !beyond_v) continue;
        sh::CubePoint p = sh::texelCenter(face, column, row, side);
        // The corners of the rim meet two neighbours: the one beside is taken, at its border.
        if (beyond_u && beyond_v) p.v = std::clamp(p.v, -1.0, 1.0);
        const dvec3 d = sh::kCubeFaces[static_cast<std::size_t>(face)].forward +
                        p.u * sh::kCubeFaces[static_cast<std::size_t>(face)].right -
                        p.v * sh::kCubeFaces[static_cast<std::size_t>(face)].up;
        const sh::CubePoint there = sh::cubePoint(d);
        const auto depth =
            glm::dot(d, sh::kCubeFaces[static_cast<std::size_t>(there.face)].forward);
        at(face, row, column) =
            static_cast<float>(depth) * bilinear(there.face, there.u, there.v, 0.0, inner);
      }
    }
  }
}

float& ProbeDepth::at(int face, int row, int column) {
  const int wide = side_ + 2;
  return inverse_[static_cast<std::size_t>((face * wide + row + 1) * wide + column + 1)];
}

/// Between texel centres, numbered from 0; places are limited to `least` .. `most`.
float ProbeDepth::bilinear(int face, double u, double v, double least, double most) const {
  const double x = std::clamp(0.5 * (u + 1.0) * side_ - 0.5, least, most);
  const double y = std::clamp(0.5 * (v + 1.0) * side_ - 0.5, least, most);
  const int i = std::min(static_cast<int>(std::floor(x)), static_cast<int>(most) - 1);
  const int j = std::min(static_cast<int>(std::floor(y)), static_cast<int>(most) - 1);
  const auto s = static_cast<float>(x - i);
  const auto t = static_cast<float>(y - j);
  const std::size_t wide = static_cast<std::size_t>(side_) + 2;
  const float* first =
      inverse_.data() +
      (static_cast<std::size_t>(face) * wide + static_cast<std::size_t>(j + 1)) * wide +
      static_cast<std::size_t>(i + 1);
  return glm::mix(glm::mix(first[0], first[1], s), glm::mix(first[wide], first[wide + 1], s), t);
}

float ProbeDepth::toward(const vec3& direction) const {
  const sh::CubePoint p = sh::cubePoint(dvec3(direction));
  const float inverse = bilinear(p.face, p.u, p.v, -0.5, side_ - 0.5);
  return static_cast<float>(std::sqrt(1.0 + p.u * p.u + p.v * p.v)) / inverse;
}

float ProbeDepth::reach(const vec3& probe, const vec3& p, const vec3& d, float far) const {
  // How far a place on the ray is behind what the probe sees in its direction.
  const auto behind = [&](float t) {
    const vec3 v = p + t * d - probe;
    const float distance = glm::length(v);
    return distance > 0.0F ? distance * (1.0F - kOnSurface) - toward(v) : -1.0F;
  };
  float before = 0.0F;
  float step_start = behind(0.0F);
  for (int i = 1; i <= kSteps; ++i) {
    const float share = static_cast<float>(i) / kSteps;
    const float t = far * share * std::sqrt(share);
    const float now = behind(t);
    // From free to behind within the step: a surface. Behind all along: hidden from the probe.
    if (now > 0.0F && step_start <= 0.0F) {
      float low = before;
      float high = t;
      for (int k = 0; k < kBisections; ++k) {
        const float middle = 0.5F * (low + high);
        (behind(middle) > 0.0F ? high : low) = middle;
      }
      if (behind(high + kBeyond) < kMostBehind) return 0.5F * (low + high);
    }
    before = t;
    step_start = now;
  }
  return far;
}

}  // namespace soffit::glossy

// SPDX-License-Identifier: MIT
#include "core/glossy/parallax.h"

#include "core/sh/cube_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace soffit::glossy {
namespace {

constexpr int kSteps = 24;
constexpr int kBisections = 6;
/// Texels are not points: what is less behind, as a share of its distance, is on the surface.
constexpr float kOnSurface = 0.03F;

Lookup lookupOf(const vec3& probe, const vec3& p, const vec3& d, float t) {
  const vec3 from_probe = p + t * d - probe;
  const float distance = glm::length(from_probe);
  if (!(distance > 1.0e-6F)) return {d, 1.0F};
  return {from_probe / distance, t / distance};
}

}  // namespace

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
  return lookupOf(probe, p, d, *t);
}

ProbeDepth::ProbeDepth(int side, std::vector<float> distances)
    : side_(side), distances_(std::move(distances)) {
  assert(distances_.size() == 6 * static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
}

float ProbeDepth::toward(const vec3& direction) const {
  return distances_[sh::texelOf(dvec3(direction), side_)];
}

Lookup ProbeDepth::throughDepth(const vec3& probe, const vec3& p, const vec3& d, float far) const {
  // How far a place on the ray is behind what the probe sees in its direction.
  const auto behind = [&](float t) {
    const vec3 v = p + t * d - probe;
    const float distance = glm::length(v);
    return distance > 0.0F ? distance * (1.0F - kOnSurface) - toward(v) : -1.0F;
  };
  float before = 0.0F;
  float step_start = behind(0.0F);
  for (int i = 1; i <= kSteps; ++i) {
    const float t = far * static_cast<float>(i) / kSteps;
    const float now = behind(t);
    // From free to behind within the step: a surface. Behind all along: hidden from the probe.
    if (now > 0.0F && step_start <= 0.0F) {
      float low = before;
      float high = t;
      for (int k = 0; k < kBisections; ++k) {
        const float middle = 0.5F * (low + high);
        (behind(middle) > 0.0F ? high : low) = middle;
      }
      return lookupOf(probe, p, d, 0.5F * (low + high));
    }
    before = t;
    step_start = now;
  }
  return lookupOf(probe, p, d, far);
}

}  // namespace soffit::glossy

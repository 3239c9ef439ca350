// SPDX-License-Identifier: MIT
#pragma once

// GLM is the one third-party type in core's public headers. Column vectors, radians.
#ifndef GLM_FORCE_XYZW_ONLY
#define GLM_FORCE_XYZW_ONLY
#endif
#include <glm/glm.hpp>

#include <cmath>

namespace soffit {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;
using glm::mat3;
using glm::uvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline constexpr double kPi = 3.14159265358979323846;

constexpr double radians(double deg) { return deg * (kPi / 180.0); }
constexpr double degrees(double rad) { return rad * (180.0 / kPi); }

inline bool isFinite(const dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Rotation by degrees about the fixed x, then y, then z axis, counter-clockwise seen from the
/// tip of the axis: v_world = Rz Ry Rx v_local. Multiples of 90 degrees are exact.
dmat3 rotationXyz(const dvec3& rotation_deg);

}  // namespace soffit

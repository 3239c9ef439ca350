// SPDX-License-Identifier: MIT
#include "core/photometry/glare.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soffit::photometry {

double ugr(std::span<const GlareSource> sources, Illuminance indirect_at_eye) {
  double sum = 0.0;
  for (const GlareSource& s : sources) {
    const double l = s.luminance.cd_per_m2;
    sum += l * l * s.solid_angle.sr / (s.position_index * s.position_index);
  }
  const double background = indirect_at_eye.lx / kPi;
  return 8.0 * std::log10(0.25 / background * sum);
}

double guthPositionIndex(double tau, double sigma) {
  if (sigma >= kPi / 2.0) return std::numeric_limits<double>::infinity();
  const double t = degrees(tau);
  const double s = degrees(sigma);
  const double linear = 35.2 - 0.31889 * t - 1.22 * std::exp(-2.0 * t / 9.0);
  const double square = 21.0 + 0.26667 * t - 0.002963 * t * t;
  return std::exp(linear * 1e-3 * s + square * 1e-5 * s * s);
}

double positionIndex(const dvec3& view, const dvec3& up, const dvec3& to_source) {
  const double ahead = glm::dot(view, to_source);
  if (!(ahead > 0.0)) return std::numeric_limits<double>::infinity();
  const dvec3 upright = glm::normalize(up - glm::dot(up, view) * view);
  const dvec3 offset = to_source - ahead * view;
  const double height = glm::dot(offset, upright);
  const double side = glm::length(offset - height * upright);
  if (height < 0.0) {
    const double ratio = std::hypot(height, side) / ahead;
    return 1.0 + (ratio < 0.6 ? 0.8 : 1.2) * ratio;
  }
  const double sigma = std::atan2(std::hypot(height, side), ahead);
  return guthPositionIndex(std::atan2(side, height), sigma);
}

}  // namespace soffit::photometry

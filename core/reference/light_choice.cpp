// SPDX-License-Identifier: MIT
#include "core/reference/light_choice.h"

#include <algorithm>
#include <cmath>

namespace soffit::reference {
namespace {

using light::Emitter;
using light::EmitterKind;

/// How much of its brightness a luminaire turns toward y, roughly; 0 only if exactly nothing.
double facing(const LightShape& light, const dvec3& y, double distance) {
  const Emitter& e = light.emitter();
  if (e.table != nullptr) {
    const double mean = e.flux / (4.0 * kPi);
    if (!(distance > 2.0 * light.radius()) || !(mean > 0.0)) return 1.0;
    const double toward = e.pointIntensity((y - light.center()) / distance) / mean;
    return 0.05 + std::min(toward, 20.0);
  }
  const bool flat = e.kind == EmitterKind::planar || (e.kind == EmitterKind::point && e.lambertian);
  if (!flat) return 1.0;
  const dvec3& anchor = e.kind == EmitterKind::planar && !e.disk ? e.outline[0] : e.position;
  const double height = glm::dot(y - anchor, e.normal);
  if (height <= 0.0) return 0.0;
  return 4.0 * std::clamp((height + 0.1 * light.radius()) / (distance + 1e-300), 0.02, 1.0);
}

double weightOf(const LightShape& light, const dvec3& y, const dvec3& n) {
  const Emitter& e = light.emitter();
  const double power = e.gain * e.flux;
  if (!(power > 0.0)) return 0.0;
  const dvec3 to = light.center() - y;
  const double distance = glm::length(to);
  const double height = glm::dot(to, n);
  double slant = 1.0;
  if (n != dvec3(0.0)) {
    // The bounding sphere lies below the horizon; its box is rounded outwards, so this is exact.
    if (height < -light.radius()) return 0.0;
    slant = std::clamp((height + 0.5 * light.radius()) / (distance + 1e-300), 0.02, 1.0);
  }
  const double reach = std::max(distance, light.radius());
  return power * facing(light, y, distance) * slant / std::max(reach * reach, 1e-12);
}

}  // namespace

void LightChoice::prepare(std::span<const LightShape> lights, const dvec3& y, const dvec3& n) {
  sums_.resize(lights.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    sum += weightOf(lights[i], y, n);
    sums_[i] = sum;
  }
}

LightChoice::Picked LightChoice::pick(double u) const {
  if (sums_.empty() || !(sums_.back() > 0.0)) return {};
  const auto it = std::upper_bound(sums_.begin(), sums_.end(), u * sums_.back());
  // Rounding can carry u to the very end: the last light with any weight is meant then.
  const auto end = std::lower_bound(sums_.begin(), sums_.end(), sums_.back());
  const auto light = static_cast<std::size_t>(std::min(it, end) - sums_.begin());
  return {light, probability(light)};
}

double LightChoice::probability(std::size_t light) const {
  const double before = light == 0 ? 0.0 : sums_[light - 1];
  return sums_.back() > 0.0 ? (sums_[light] - before) / sums_.back() : 0.0;
}

}  // namespace soffit::reference

// SPDX-License-Identifier: MIT
#include "core/prt/luminaire_light.h"

#include "core/sh/basis.h"
#include "core/sh/sphere_light.h"

#include <algorithm>
#include <cmath>

namespace soffit::prt {
namespace {

/// A disk as a polygon of the same area.
std::vector<dvec3> diskOutline(const light::Emitter& emitter) {
  constexpr int kCorners = 48;
  const double step = 2.0 * kPi / kCorners;
  const double radius = emitter.radius * std::sqrt(step / std::sin(step));
  const dvec3 other = std::abs(emitter.normal.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
  const dvec3 t = glm::normalize(glm::cross(other, emitter.normal));
  const dvec3 b = glm::cross(emitter.normal, t);
  std::vector<dvec3> outline;
  for (int i = 0; i < kCorners; ++i) {
    const double phi = (i + 0.5) * step;
    outline.push_back(emitter.position + radius * (std::cos(phi) * t + std::sin(phi) * b));
  }
  return outline;
}

/// What p sees of a tube's lateral surface, as a rectangle as wide as the tube looks, at the mean
/// depth of the half that is seen; empty from within. The ends are not round: 1e-3.
std::vector<dvec3> tubeOutline(const light::Emitter& tube, const dvec3& p) {
  const dvec3 to = p - tube.position;
  const dvec3 off = to - glm::dot(to, tube.axis) * tube.axis;
  const double d = glm::length(off);
  const double r = tube.radius;
  if (d <= 1.001 * r) return {};
  const double nearer = 0.25 * kPi * r;  // mean of the depth, by width as it looks
  const dvec3 c = tube.position + (nearer / d) * off;
  const double half_width = (d - nearer) * r / std::sqrt(d * d - r * r);
  const dvec3 across = glm::cross(tube.axis, off) * (half_width / d);
  const dvec3 along = tube.half_length * tube.axis;
  return {c - along - across, c - along + across, c + along + across, c + along - across};
}

void scale(sh::Coefficients& values, double factor) {
  for (double& v : values) v *= factor;
}

}  // namespace

LuminaireLight::LuminaireLight(const light::Emitter& emitter) : light_(emitter) {
  if (!emitter.lambertian || emitter.luminance <= 0.0) return;
  if (emitter.kind == light::EmitterKind::planar) {
    outline_ = emitter.disk ? diskOutline(emitter) : emitter.outline;
  }
  uniform_sphere_ = emitter.kind == light::EmitterKind::sphere;
  uniform_tube_ = emitter.kind == light::EmitterKind::tube;
}

std::vector<dvec3> LuminaireLight::outlineFrom(const dvec3& p) const {
  return uniform_tube_ ? tubeOutline(emitter(), p) : outline_;
}

bool LuminaireLight::dark(const dvec3& p) const {
  const light::Emitter& e = emitter();
  if (e.flux <= 0.0) return true;
  if (e.kind != light::EmitterKind::planar || e.twoSided() || !e.lambertian) return false;
  return glm::dot(p - e.position, e.normal) <= 0.0;
}

double LuminaireLight::distance(const dvec3& p) const {
  const dvec3 lo(emitter().bounds.lo);
  const dvec3 hi(emitter().bounds.hi);
  return glm::length(p - glm::clamp(p, lo, hi));
}

sh::Coefficients LuminaireLight::bySamples(const dvec3& p, int bands) const {
  const light::Emitter& e = emitter();
  const auto distance_m = static_cast<float>(distance(p));
  // Two levels finer than irradiance asks for: harmonics of degree 4 vary as quickly as they do.
  const int level =
      std::min(light_.sampleLevel(distance_m) + 2, light::PreparedLight::kSampleLevels - 1);
  const light::PointLightSamples& samples = light_.samples(level);
  sh::Coefficients out(sh::coefficientCount(bands), 0.0);
  std::vector<double> basis(out.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const dvec3 to = dvec3(samples.x[k], samples.y[k], samples.z[k]) - p;
    const double r2 = glm::dot(to, to);
    if (r2 <= 0.0) continue;
    const dvec3 direction = to / std::sqrt(r2);
    const dvec3 normal(samples.nx[k], samples.ny[k], samples.nz[k]);
    const double intensity = e.kind == light::EmitterKind::point
                                 ? e.pointIntensity(-direction)
                                 : e.intensityPerArea(normal, -direction);
    if (intensity <= 0.0) continue;
    sh::evaluate(direction, bands, basis);
    const double weight = static_cast<double>(samples.weight[k]) * intensity / r2;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += weight * basis[i];
  }
  return out;
}

sh::Coefficients LuminaireLight::at(const dvec3& p, int bands) const {
  const light::Emitter& e = emitter();
  if (dark(p)) return sh::Coefficients(sh::coefficientCount(bands), 0.0);
  sh::Coefficients out;
  if (const auto outline = outlineFrom(p); !outline.empty()) {
    out = sh::polygonCoefficients(outline, p, bands);
  } else if (uniform_sphere_ && glm::length(p - e.position) > e.radius) {
    out = sh::sphereCoefficients(e.position, e.radius, p, bands);
  } else {
    return bySamples(p, bands);
  }
  scale(out, e.luminance);
  return out;
}

std::optional<sh::CoefficientsWithGradient> LuminaireLight::around(const dvec3& p,
                                                                   int bands) const {
  constexpr double kGrazing = 0.05;
  const light::Emitter& e = emitter();
  sh::CoefficientsWithGradient out;
  if (const auto outline = outlineFrom(p); !outline.empty()) {
    const dvec3 to = p - e.position;
    if (!uniform_tube_ && glm::dot(to, e.normal) < kGrazing * glm::length(to)) return {};
    out = sh::polygonCoefficientsWithGradient(outline, p, bands);
  } else if (uniform_sphere_ && glm::length(p - e.position) > e.radius) {
    out = sh::sphereCoefficientsWithGradient(e.position, e.radius, p, bands);
  } else {
    return {};
  }
  scale(out.values, e.luminance);
  for (dvec3& g : out.gradients) g *= e.luminance;
  return out;
}

}  // namespace soffit::prt

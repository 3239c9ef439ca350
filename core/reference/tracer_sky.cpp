// SPDX-License-Identifier: MIT
// The tracer's part out of doors: surroundings, sun, and the sheets of glass before them.
#include "core/math/sampling.h"
#include "core/reference/tracer.h"

#include <algorithm>
#include <cmath>

namespace soffit::reference {
namespace {

/// Between two panes that face each other at grazing incidence little is lost from one mirroring
/// to the next; what is left after so many is not worth following.
constexpr int kMostSheets = 24;

/// 1 - cos of the sun's radius: its solid angle over 2 pi.
double sunCap() {
  const double half = std::sin(0.5 * daylight::Sun::kRadius);
  return 2.0 * half * half;
}

dvec3 towardSun(const daylight::Sun& sun, const dvec3& u) {
  const double one_minus = u.x * sunCap();
  const double cosine = 1.0 - one_minus;
  const double sine = std::sqrt(one_minus * (1.0 + cosine));
  dvec3 t(0.0);
  dvec3 b(0.0);
  orthonormalBasis(sun.direction, t, b);
  const double phi = 2.0 * kPi * u.y;
  return cosine * sun.direction + sine * (std::cos(phi) * t + std::sin(phi) * b);
}

}  // namespace

void Tracer::sendSky(const dvec3& y, const dvec3& u_sky, const dvec3& u_sun, const Bsdf* bsdf,
                     const dvec3& wo, const dvec3& beta) {
  const auto send = [&](const dvec3& wi, double drawn, const dvec3& radiance) {
    if (!(drawn > 0.0) || radiance == dvec3(0.0)) return;
    const dvec3 response = bsdf != nullptr
                               ? evaluate(*bsdf, wo, wi) * std::max(0.0, glm::dot(bsdf->normal, wi))
                               : dvec3(response_.weight(wi));
    if (response == dvec3(0.0)) return;
    const double followed = bsdf != nullptr ? density(*bsdf, wo, wi) : response_.density(wi);
    sky_shadows_.push_back({y, wi, beta * response * radiance / (drawn + followed)});
  };
  const SkyChoice::Drawn sky = scene_.sky()->draw(y, u_sky);
  send(sky.direction, sky.density, scene_.environment()->radiance(sky.direction));
  if (const auto& sun = scene_.environment()->sun()) {
    send(towardSun(*sun, u_sun), 1.0 / (2.0 * kPi * sunCap()), dvec3(sun->radiance()));
  }
}

void Tracer::traceSkyShadows() {
  rays_.clear();
  for (const SkyShadow& s : sky_shadows_) {
    rays_.push_back({vec3(s.origin), 0.0F, vec3(s.direction)});
  }
  blocked_.resize(rays_.size());
  scene_.caster().occluded(rays_, blocked_);
  ray_count_ += rays_.size();
  share_.resize(rays_.size());
  for (std::size_t i = 0; i < rays_.size(); ++i) share_[i] = blocked_[i] == 0 ? 1.0F : 0.0F;
  if (scene_.panes() != nullptr) scene_.panes()->attenuate(rays_, share_);
  for (std::size_t i = 0; i < sky_shadows_.size(); ++i) {
    if (share_[i] <= 0.0F) continue;
    const Line line{sky_shadows_[i].origin, sky_shadows_[i].direction};
    const auto hides = [&](std::uint32_t body) {
      return scene_.lights()[body].bodyDistance(line, kInfinity) < kInfinity;
    };
    if (std::ranges::any_of(scene_.bodies(), hides)) continue;
    bin() += double(share_[i]) * sky_shadows_[i].light_sent;
  }
  sky_shadows_.clear();
}

void Tracer::gatherSky(const Path& path) {
  const daylight::Environment& environment = *scene_.environment();
  const dvec3 beta = path.beta * throughPanes(kInfinity);
  const auto weight = [&](double drawn) {
    return path.density > 0.0 ? path.density / (path.density + drawn) : 1.0;
  };
  const dvec3 radiance = environment.radiance(path.direction);
  if (radiance != dvec3(0.0)) {
    const double drawn =
        path.density > 0.0 ? scene_.sky()->density(path.origin, path.direction) : 0.0;
    binOf(path) += beta * radiance * weight(drawn);
  }
  const auto& sun = environment.sun();
  if (sun && path.sheets == 0 && sun->covers(path.direction)) {
    binOf(path) += beta * sun->radiance() * weight(1.0 / (2.0 * kPi * sunCap()));
  }
}

void Tracer::crossPanes(const Path& path, double t_end) {
  const daylight::Panes& panes = *scene_.panes();
  geometry::Ray ray{vec3(path.origin), 0.0F, vec3(path.direction)};
  ray.t_max = static_cast<float>(t_end);
  daylight::PaneCrossing at;
  double passed = 1.0;
  while (passed > 0.0 && panes.next(ray, at)) {
    if (path.sheets < kMostSheets && rng_.uniformDouble() < at.reflected) {
      const vec3 up = panes.normal(at.triangle);
      const vec3 n = glm::dot(up, ray.direction) > 0.0F ? -up : up;
      const vec3 point = ray.origin + at.t * ray.direction;
      const dvec3 d = path.direction;
      mirrored_.push_back({path.index, dvec3(geometry::offsetOrigin(point, n)), dvec3(n),
                           glm::normalize(d - 2.0 * glm::dot(d, dvec3(n)) * dvec3(n)),
                           path.beta * passed, 0.0, path.sheets + 1});
    }
    panes_.push_back(at);
    passed *= at.transmitted;
    ray.t_min = daylight::Panes::beyond(at.t, ray.direction);
  }
}

double Tracer::throughPanes(double t) const {
  double share = 1.0;
  for (const daylight::PaneCrossing& pane : panes_) {
    if (static_cast<double>(pane.t) < t) share *= pane.transmitted;
  }
  return share;
}

}  // namespace soffit::reference

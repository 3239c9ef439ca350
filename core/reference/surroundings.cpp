// SPDX-License-Identifier: MIT
#include "core/reference/surroundings.h"

#include <algorithm>
#include <cmath>

namespace soffit::reference {

SkyChoice::SkyChoice(const daylight::Environment& environment, const daylight::Panes* panes,
                     const geometry::Mesh& mesh)
    : environment_(environment), panes_(panes), mesh_(mesh) {
  if (panes_ == nullptr) return;
  double sum = 0.0;
  for (const std::uint32_t t : panes_->triangles()) {
    areas_.push_back(sum += static_cast<double>(panes_->area(t)));
  }
  if (!(sum > 0.0)) panes_ = nullptr;
}

SkyChoice::Drawn SkyChoice::draw(const dvec3& y, const dvec3& u) const {
  Drawn out;
  if (panes_ == nullptr || u.z < 0.5) {
    out.direction = environment_.table().sample({u.x, u.y}).direction;
  } else {
    // u.z chooses the triangle, uniformly by area.
    const double target = (2.0 * u.z - 1.0) * areas_.back();
    const auto found = std::upper_bound(areas_.begin(), areas_.end() - 1, target);
    const std::uint32_t t = panes_->triangles()[static_cast<std::size_t>(found - areas_.begin())];
    const uvec3& c = mesh_.triangles[t];
    const dvec3 a(mesh_.positions[c.x]);
    const bool folded = u.x + u.y > 1.0;
    const double p = folded ? 1.0 - u.x : u.x;
    const double q = folded ? 1.0 - u.y : u.y;
    const dvec3 to =
        a + p * (dvec3(mesh_.positions[c.y]) - a) + q * (dvec3(mesh_.positions[c.z]) - a) - y;
    const double length = glm::length(to);
    if (!(length > 0.0)) return {};
    out.direction = to / length;
  }
  out.density = density(y, out.direction);
  return out;
}

double SkyChoice::density(const dvec3& y, const dvec3& direction) const {
  const double by_light = environment_.table().density(direction);
  return panes_ == nullptr ? by_light : 0.5 * (by_light + paneDensity(y, direction));
}

double SkyChoice::paneDensity(const dvec3& y, const dvec3& direction) const {
  // Every pane that the direction crosses could have been drawn, whatever stands before it.
  geometry::Ray ray{vec3(y), 0.0F, vec3(direction)};
  daylight::PaneCrossing at;
  double sum = 0.0;
  while (panes_->next(ray, at)) {
    const double cosine = std::abs(glm::dot(dvec3(panes_->normal(at.triangle)), direction));
    if (cosine > 0.0) sum += static_cast<double>(at.t) * static_cast<double>(at.t) / cosine;
    ray.t_min = daylight::Panes::beyond(at.t, ray.direction);
  }
  return sum / areas_.back();
}

}  // namespace soffit::reference

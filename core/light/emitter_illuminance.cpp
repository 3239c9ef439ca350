// SPDX-License-Identifier: MIT
#include "core/light/emitter_illuminance.h"

#include "core/light/polygon_irradiance.h"

#include <cmath>
#include <span>

namespace soffit::light {

double sampledIlluminance(const Emitter& e, const PointLightSamples& s, const dvec3& p,
                          const dvec3& n) {
  double sum = 0.0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    const dvec3 to = dvec3(s.x[k], s.y[k], s.z[k]) - p;
    const double r2 = glm::dot(to, to);
    const double cos_p = glm::dot(n, to);
    if (cos_p <= 0.0 || r2 <= 0.0) continue;
    const double r = std::sqrt(r2);
    const dvec3 w = to / -r;
    const double intensity =
        e.kind == EmitterKind::point
            ? e.pointIntensity(w)
            : e.intensityPerArea(dvec3(s.nx[k], s.ny[k], s.nz[k]), w) * s.weight[k];
    sum += intensity * cos_p / (r2 * r);
  }
  return sum;
}

double closedForm(const Emitter& e, const dvec3& p, const dvec3& n) {
  switch (e.kind) {
    case EmitterKind::planar:
      if (glm::dot(p - (e.disk ? e.position : e.outline[0]), e.normal) <= 0.0) return 0.0;
      return e.luminance * (e.disk ? diskIrradiance(e.position, e.normal, e.radius, p, n)
                                   : polygonIrradiance(e.outline, p, n));
    case EmitterKind::sphere:
      return e.luminance * sphereIrradiance(e.position, e.radius, p, n);
    case EmitterKind::tube:
      return e.luminance * tubeIrradiance(e.position, e.axis, e.half_length, e.radius, p, n);
    case EmitterKind::mesh: {
      double sum = 0.0;
      for (std::size_t t = 0; t < e.triangle_areas.size(); ++t) {
        const std::span<const dvec3> corners(e.corners.data() + 3 * t, 3);
        if (glm::dot(p - corners[0], e.triangle_normals[t]) > 0.0)
          sum += polygonIrradiance(corners, p, n);
      }
      return e.luminance * sum;
    }
    case EmitterKind::point:
      break;
  }
  return 0.0;
}

}  // namespace soffit::light

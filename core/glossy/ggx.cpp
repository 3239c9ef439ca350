// SPDX-License-Identifier: MIT
#include "core/glossy/ggx.h"

#include <algorithm>
#include <cmath>

namespace soffit::glossy {

double schlickRise(double cosine) {
  const double m = std::clamp(1.0 - cosine, 0.0, 1.0);
  return m * m * m * m * m;
}

double ggxDensity(double cos_h, double alpha) {
  if (cos_h <= 0.0) return 0.0;
  const double a2 = alpha * alpha;
  const double d = (1.0 - cos_h) * (1.0 + cos_h) + a2 * cos_h * cos_h;
  return a2 / (kPi * d * d);
}

double smithLambda(double cosine, double alpha) {
  const double cos2 = cosine * cosine;
  if (cos2 <= 0.0) return 1.0e18;
  const double tan2 = std::max(0.0, 1.0 - cos2) / cos2;
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * tan2) - 1.0);
}

double ggxLobe(const dvec3& wo, const dvec3& wi, double alpha) {
  if (wo.z <= 0.0 || wi.z <= 0.0) return 0.0;
  const dvec3 h = glm::normalize(wo + wi);
  const double g2 = 1.0 / (1.0 + smithLambda(wo.z, alpha) + smithLambda(wi.z, alpha));
  return ggxDensity(h.z, alpha) * g2 / (4.0 * wo.z);
}

GgxDraw drawGgx(const dvec3& wo, double alpha, const dvec2& u) {
  // Heitz 2018, listing 1: a uniform point of the half disk that the stretched view sees.
  const dvec3 v = glm::normalize(dvec3(alpha * wo.x, alpha * wo.y, wo.z));
  const double length2 = v.x * v.x + v.y * v.y;
  const dvec3 t1 =
      length2 > 0.0 ? dvec3(-v.y, v.x, 0.0) / std::sqrt(length2) : dvec3(1.0, 0.0, 0.0);
  const dvec3 t2 = glm::cross(v, t1);
  const double r = std::sqrt(u.x);
  const double a = r * std::cos(2.0 * kPi * u.y);
  const double s = 0.5 * (1.0 + v.z);
  const double b =
      (1.0 - s) * std::sqrt(std::max(0.0, 1.0 - a * a)) + s * r * std::sin(2.0 * kPi * u.y);
  const dvec3 n = a * t1 + b * t2 + std::sqrt(std::max(0.0, 1.0 - a * a - b * b)) * v;
  const dvec3 h = glm::normalize(dvec3(alpha * n.x, alpha * n.y, std::max(1.0e-9, n.z)));
  GgxDraw draw;
  draw.cos_h = glm::dot(wo, h);
  draw.wi = 2.0 * draw.cos_h * h - wo;
  if (draw.wi.z <= 0.0) return draw;
  const double masking = 1.0 + smithLambda(wo.z, alpha);
  draw.weight = masking / (masking + smithLambda(draw.wi.z, alpha));
  return draw;
}

}  // namespace soffit::glossy

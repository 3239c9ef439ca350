// SPDX-License-Identifier: MIT
#include "core/render/microfacet.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

constexpr float kPiF = 3.14159265358979F;

/// Smith's Lambda for GGX: (sqrt(1 + alpha^2 tan^2) - 1) / 2.
float lambda(const vec3& w, float alpha) {
  const float cos2 = w.z * w.z;
  if (cos2 <= 0.0F) return 1.0e18F;
  const float tan2 = std::max(0.0F, 1.0F - cos2) / cos2;
  return 0.5F * (std::sqrt(1.0F + alpha * alpha * tan2) - 1.0F);
}

/// A half vector drawn from the visible normals (Heitz 2018, listing 1, isotropic).
vec3 visibleNormal(const vec3& wo, float alpha, const vec2& u) {
  const vec3 v = glm::normalize(vec3(alpha * wo.x, alpha * wo.y, wo.z));
  const float length2 = v.x * v.x + v.y * v.y;
  const vec3 t1 =
      length2 > 0.0F ? vec3(-v.y, v.x, 0.0F) / std::sqrt(length2) : vec3(1.0F, 0.0F, 0.0F);
  const vec3 t2 = glm::cross(v, t1);
  const float r = std::sqrt(u.x);
  const float phi = 2.0F * kPiF * u.y;
  const float a = r * std::cos(phi);
  const float s = 0.5F * (1.0F + v.z);
  const float b = (1.0F - s) * std::sqrt(std::max(0.0F, 1.0F - a * a)) + s * r * std::sin(phi);
  const vec3 n = a * t1 + b * t2 + std::sqrt(std::max(0.0F, 1.0F - a * a - b * b)) * v;
  return glm::normalize(vec3(alpha * n.x, alpha * n.y, std::max(1.0e-6F, n.z)));
}

}  // namespace

float schlick(float f0, float cosine) {
  const float m = std::clamp(1.0F - cosine, 0.0F, 1.0F);
  const float m2 = m * m;
  return f0 + (1.0F - f0) * m2 * m2 * m;
}

float ggxDensity(float cos_h, float alpha) {
  if (cos_h <= 0.0F) return 0.0F;
  const float a2 = alpha * alpha;
  // sin^2 + alpha^2 cos^2 rather than 1 + cos^2 (alpha^2 - 1): the latter cancels for small alpha.
  const float d = (1.0F - cos_h) * (1.0F + cos_h) + a2 * cos_h * cos_h;
  return a2 / (kPiF * d * d);
}

float ggxReflection(const vec3& wo, const vec3& wi, float f0, float alpha) {
  if (alpha < kMirrorAlpha || wo.z <= 0.0F || wi.z <= 0.0F) return 0.0F;
  const vec3 h = glm::normalize(wo + wi);
  const float g2 = 1.0F / (1.0F + lambda(wo, alpha) + lambda(wi, alpha));
  return ggxDensity(h.z, alpha) * g2 * schlick(f0, glm::dot(wo, h)) / (4.0F * wo.z);
}

float ggxPdf(const vec3& wo, const vec3& wi, float alpha) {
  if (alpha < kMirrorAlpha || wo.z <= 0.0F || wi.z <= 0.0F) return 0.0F;
  const vec3 h = glm::normalize(wo + wi);
  const float g1 = 1.0F / (1.0F + lambda(wo, alpha));
  return g1 * ggxDensity(h.z, alpha) / (4.0F * wo.z);
}

LobeSample sampleGgx(const vec3& wo, float f0, float alpha, const vec2& u) {
  if (wo.z <= 0.0F) return {};
  if (alpha < kMirrorAlpha) return {{-wo.x, -wo.y, wo.z}, schlick(f0, wo.z), 0.0F};
  const vec3 h = visibleNormal(wo, alpha, u);
  const float cos_oh = glm::dot(wo, h);
  const vec3 wi = 2.0F * cos_oh * h - wo;
  if (wi.z <= 0.0F) return {wi, 0.0F, 0.0F};
  const float masking = 1.0F + lambda(wo, alpha);
  return {wi, schlick(f0, cos_oh) * masking / (masking + lambda(wi, alpha)), ggxPdf(wo, wi, alpha)};
}

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#include "core/reference/bsdf.h"

#include "core/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace soffit::reference {
namespace {

constexpr dvec3 kLuminance{0.2126390058715104, 0.7151686787677560, 0.0721923153607336};

double schlick(double specular, double cosine) {
  const double m = std::clamp(1.0 - cosine, 0.0, 1.0);
  return specular + (1.0 - specular) * m * m * m * m * m;
}

/// GGX density of microfacet normals; cosine to the surface normal. The form without 1 - c^2
/// near 1 keeps its digits for small alpha.
double ggx(double alpha, double cosine, double sine_squared) {
  const double d = cosine * cosine * alpha * alpha + sine_squared;
  return alpha * alpha / (kPi * d * d);
}

/// Smith's Lambda: (sqrt(1 + alpha^2 tan^2) - 1) / 2.
double lambda(double alpha, double cosine) {
  const double c2 = cosine * cosine;
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * std::max(0.0, 1.0 - c2) / c2) - 1.0);
}

bool isMirror(const Bsdf& b) {
  return b.specular > 0.0 && b.alpha <= 0.0;
}

/// Share of the samples that go to the lobe.
double lobeShare(const Bsdf& b, double cos_o) {
  if (!(b.specular > 0.0)) return 0.0;
  const double lobe = schlick(b.specular, cos_o);
  return lobe / (lobe + glm::dot(b.diffuse, kLuminance));
}

struct HalfVector {
  double facet;  ///< D, per steradian
  double cos_oh;
};

HalfVector halfVector(const Bsdf& b, const dvec3& wo, const dvec3& wi) {
  const dvec3 h = glm::normalize(wo + wi);
  const dvec3 across = glm::cross(b.normal, h);
  return {ggx(b.alpha, glm::dot(b.normal, h), glm::dot(across, across)),
          std::max(0.0, glm::dot(wo, h))};
}

/// A microfacet normal as seen from wo (Heitz 2018, "Sampling the GGX Distribution of Visible
/// Normals"); wo and the result in the frame whose z is the surface normal.
dvec3 visibleNormal(double alpha, const dvec3& wo, const dvec2& u) {
  const dvec3 v = glm::normalize(dvec3(alpha * wo.x, alpha * wo.y, wo.z));
  dvec3 t1(0.0);
  dvec3 t2(0.0);
  orthonormalBasis(v, t1, t2);
  // Any tangent pair will do for the disk if its lower half is squeezed along the one that tilts
  // toward the pole; that needs t1 horizontal.
  const double horizontal = std::sqrt(v.x * v.x + v.y * v.y);
  if (horizontal > 1e-12) {
    t1 = dvec3(-v.y, v.x, 0.0) / horizontal;
    t2 = glm::cross(v, t1);
  }
  const double r = std::sqrt(u.x);
  const double phi = 2.0 * kPi * u.y;
  const double p1 = r * std::cos(phi);
  const double s = 0.5 * (1.0 + v.z);
  const double p2 = (1.0 - s) * std::sqrt(std::max(0.0, 1.0 - p1 * p1)) + s * r * std::sin(phi);
  const dvec3 n = p1 * t1 + p2 * t2 + std::sqrt(std::max(0.0, 1.0 - p1 * p1 - p2 * p2)) * v;
  return glm::normalize(dvec3(alpha * n.x, alpha * n.y, std::max(1e-12, n.z)));
}

dvec3 sampleLobe(const Bsdf& b, const dvec3& wo, const dvec2& u) {
  if (isMirror(b)) return 2.0 * glm::dot(wo, b.normal) * b.normal - wo;
  dvec3 t(0.0);
  dvec3 s(0.0);
  orthonormalBasis(b.normal, t, s);
  const dvec3 local(glm::dot(wo, t), glm::dot(wo, s), glm::dot(wo, b.normal));
  const dvec3 m = visibleNormal(b.alpha, local, u);
  const dvec3 h = m.x * t + m.y * s + m.z * b.normal;
  return 2.0 * glm::dot(wo, h) * h - wo;
}

dvec3 sampleCosine(const dvec3& normal, const dvec2& u) {
  dvec3 t(0.0);
  dvec3 b(0.0);
  orthonormalBasis(normal, t, b);
  const double r = std::sqrt(u.x);
  const double phi = 2.0 * kPi * u.y;
  return r * std::cos(phi) * t + r * std::sin(phi) * b + std::sqrt(1.0 - u.x) * normal;
}

}  // namespace

dvec3 evaluate(const Bsdf& b, const dvec3& wo, const dvec3& wi) {
  const double cos_o = glm::dot(b.normal, wo);
  const double cos_i = glm::dot(b.normal, wi);
  if (cos_o <= 0.0 || cos_i <= 0.0) return dvec3(0.0);
  dvec3 f = b.diffuse / kPi;
  if (b.specular > 0.0 && !isMirror(b)) {
    const HalfVector h = halfVector(b, wo, wi);
    const double masking = 1.0 / (1.0 + lambda(b.alpha, cos_o) + lambda(b.alpha, cos_i));
    f += dvec3(schlick(b.specular, h.cos_oh) * h.facet * masking / (4.0 * cos_o * cos_i));
  }
  return f;
}

double density(const Bsdf& b, const dvec3& wo, const dvec3& wi) {
  const double cos_o = glm::dot(b.normal, wo);
  const double cos_i = glm::dot(b.normal, wi);
  if (cos_o <= 0.0 || cos_i <= 0.0) return 0.0;
  const double share = lobeShare(b, cos_o);
  double p = (1.0 - share) * cos_i / kPi;
  if (share > 0.0 && !isMirror(b)) {
    // Visible normals D G1 max(0, wo.h) / cos_o, and 1 / (4 wo.h) from half to direction.
    const double visible = halfVector(b, wo, wi).facet / (1.0 + lambda(b.alpha, cos_o));
    p += share * visible / (4.0 * cos_o);
  }
  return p;
}

BsdfSample sample(const Bsdf& b, const dvec3& wo, const dvec3& u) {
  const double cos_o = glm::dot(b.normal, wo);
  if (cos_o <= 0.0) return {};
  const double share = lobeShare(b, cos_o);
  const bool lobe = u.z < share;
  BsdfSample out;
  out.direction = lobe ? sampleLobe(b, wo, {u.x, u.y}) : sampleCosine(b.normal, {u.x, u.y});
  if (lobe && isMirror(b)) {
    out.weight = dvec3(schlick(b.specular, cos_o) / share);
    return out;
  }
  out.density = density(b, wo, out.direction);
  if (!(out.density > 0.0)) return {};
  out.weight = evaluate(b, wo, out.direction) * (glm::dot(b.normal, out.direction) / out.density);
  return out;
}

dvec3 albedo(const Bsdf& b, const dvec3& wo) {
  const double lobe = b.specular > 0.0 ? schlick(b.specular, glm::dot(b.normal, wo)) : 0.0;
  return b.diffuse + lobe;
}

}  // namespace soffit::reference

// SPDX-License-Identifier: MIT
#include "core/light/emitter_sampling.h"

#include "core/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace soffit::light {
namespace {

/// Index of the triangle whose share of the area holds u, and u's place within that share.
std::size_t chooseTriangle(const std::vector<double>& area_sums, double& u) {
  const double target = u * area_sums.back();
  const auto it = std::upper_bound(area_sums.begin(), area_sums.end(), target);
  const std::size_t i =
      std::min<std::size_t>(static_cast<std::size_t>(it - area_sums.begin()), area_sums.size() - 1);
  const double before = i == 0 ? 0.0 : area_sums[i - 1];
  u = std::clamp((target - before) / (area_sums[i] - before), 0.0, std::nextafter(1.0, 0.0));
  return i;
}

/// Uniform in a triangle: the square root keeps strata of u compact.
dvec3 pointInTriangle(const dvec3& a, const dvec3& b, const dvec3& c, const dvec2& u) {
  const double s = std::sqrt(u.x);
  return (1.0 - s) * a + s * (1.0 - u.y) * b + s * u.y * c;
}

dvec3 pointInDisk(const Emitter& e, const dvec2& u) {
  dvec3 t(0.0);
  dvec3 b(0.0);
  orthonormalBasis(e.normal, t, b);
  const double r = e.radius * std::sqrt(u.x);
  const double phi = 2.0 * kPi * u.y;
  return e.position + r * std::cos(phi) * t + r * std::sin(phi) * b;
}

bool isParallelogram(const Emitter& e) {
  if (e.outline.size() != 4) return false;
  const dvec3 gap = e.outline[0] - e.outline[1] + e.outline[2] - e.outline[3];
  return glm::dot(gap, gap) <= 1e-24 * e.area;
}

dvec3 pointInOutline(const Emitter& e, dvec2 u) {
  const std::vector<dvec3>& p = e.outline;
  if (isParallelogram(e)) return p[0] + u.x * (p[1] - p[0]) + u.y * (p[3] - p[0]);
  const uvec3 t = e.outline_triangles[chooseTriangle(e.area_sums, u.x)];
  return pointInTriangle(p[t.x], p[t.y], p[t.z], u);
}

EmitterSample onSphere(const Emitter& e, const dvec2& u) {
  const double z = 1.0 - 2.0 * u.x;
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  const double phi = 2.0 * kPi * u.y;
  const dvec3 n(r * std::cos(phi), r * std::sin(phi), z);
  return {.point = e.position + e.radius * n, .normal = n, .pdf_area = 1.0 / e.area};
}

EmitterSample onTube(const Emitter& e, const dvec2& u) {
  dvec3 t(0.0);
  dvec3 b(0.0);
  orthonormalBasis(e.axis, t, b);
  const double phi = 2.0 * kPi * u.y;
  const dvec3 n = std::cos(phi) * t + std::sin(phi) * b;
  const double along = (2.0 * u.x - 1.0) * e.half_length;
  return {
      .point = e.position + along * e.axis + e.radius * n, .normal = n, .pdf_area = 1.0 / e.area};
}

EmitterSample onMesh(const Emitter& e, dvec2 u) {
  const std::size_t i = chooseTriangle(e.area_sums, u.x);
  return {.point = pointInTriangle(e.corners[3 * i], e.corners[3 * i + 1], e.corners[3 * i + 2], u),
          .normal = e.triangle_normals[i],
          .pdf_area = 1.0 / e.area};
}

}  // namespace

EmitterSample sampleByArea(const Emitter& emitter, const dvec2& u) {
  switch (emitter.kind) {
    case EmitterKind::point:
      return {.point = emitter.position, .normal = dvec3(0.0), .pdf_area = 1.0};
    case EmitterKind::planar:
      return {.point = emitter.disk ? pointInDisk(emitter, u) : pointInOutline(emitter, u),
              .normal = emitter.normal,
              .pdf_area = 1.0 / emitter.area};
    case EmitterKind::sphere:
      return onSphere(emitter, u);
    case EmitterKind::tube:
      return onTube(emitter, u);
    case EmitterKind::mesh:
      return onMesh(emitter, u);
  }
  return {};
}

}  // namespace soffit::light

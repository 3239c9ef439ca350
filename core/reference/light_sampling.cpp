// SPDX-License-Identifier: MIT
#include "core/reference/light_sampling.h"

#include "core/math/sampling.h"
#include "core/reference/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

namespace soffit::reference {
namespace {

using light::Emitter;
using light::EmitterKind;

/// Whether y is on the dark side of a one-sided planar emitter.
bool behind(const Emitter& e, const dvec3& y) {
  return e.kind == EmitterKind::planar && e.table == nullptr &&
         glm::dot(y - (e.disk ? e.position : e.outline[0]), e.normal) <= 0.0;
}

/// Near enough for the solid angle to matter, far enough from the plane for it to be accurate.
/// Measured light is left out: it shines along its surface, where solid angle vanishes.
bool bySolidAngle(const LightShape& light, const dvec3& y) {
  if (!light.isRectangle() || light.emitter().table != nullptr) return false;
  constexpr double kNear = 4.0;     // bounding radii: two diagonals
  constexpr double kHeight = 2e-3;  // bounding radii
  const double height = std::abs(glm::dot(y - light.corner(), light.emitter().normal));
  return height > kHeight * light.radius() &&
         glm::length(y - light.center()) < kNear * light.radius();
}

SphericalRectangle sphericalRectangle(const LightShape& light, const dvec3& y) {
  return {light.corner(), light.edgeX(), light.edgeY(), y};
}

/// Turns a density per steradian at y into one per square metre at a point.
double perArea(double per_steradian, const dvec3& y, const dvec3& point, const dvec3& normal) {
  const dvec3 to = point - y;
  const double distance_squared = glm::dot(to, to);
  const double distance = std::sqrt(distance_squared);
  return per_steradian * std::abs(glm::dot(normal, to)) / (distance * distance_squared);
}

/// The cone that a sphere fills, seen from outside.
struct Cone {
  dvec3 to_center;
  double distance;
  double one_minus_cos;  ///< of the half angle
};

Cone coneOf(const Emitter& e, const dvec3& y) {
  const dvec3 to = e.position - y;
  const double distance = glm::length(to);
  const double sine = e.radius / distance;
  const double cosine = std::sqrt(std::max(0.0, (1.0 - sine) * (1.0 + sine)));
  return {to, distance, sine * sine / (1.0 + cosine)};
}

bool byCone(const Emitter& e, const dvec3& y) {
  return e.kind == EmitterKind::sphere && e.table == nullptr &&
         glm::length(y - e.position) > e.radius;
}

LightPoint sampleCone(const Emitter& e, const dvec3& y, const dvec2& u) {
  const Cone cone = coneOf(e, y);
  const double one_minus = u.x * cone.one_minus_cos;
  const double cosine = 1.0 - one_minus;
  const double sine = std::sqrt(one_minus * (1.0 + cosine));
  const dvec3 axis = cone.to_center / cone.distance;
  dvec3 t(0.0);
  dvec3 b(0.0);
  orthonormalBasis(axis, t, b);
  const double phi = 2.0 * kPi * u.y;
  const dvec3 direction = cosine * axis + sine * (std::cos(phi) * t + std::sin(phi) * b);
  const double off_center = cone.distance * sine;
  const double half_chord =
      std::sqrt(std::max(0.0, (e.radius - off_center) * (e.radius + off_center)));
  const dvec3 hit = y + (cone.distance * cosine - half_chord) * direction;
  const dvec3 normal = glm::normalize(hit - e.position);
  const dvec3 point = e.position + e.radius * normal;
  return {point, normal, perArea(1.0 / (2.0 * kPi * cone.one_minus_cos), y, point, normal)};
}

/// What y sees of a tube: the strip of half width phi_max about its own direction, and the angles
/// of the tube's ends as seen from y's foot on the axis.
struct Strip {
  dvec3 outward{0.0};  ///< unit, from the axis to y
  double rho = 0.0;    ///< distance of y from the axis
  double along = 0.0;  ///< y's coordinate along the axis
  double phi_max = 0.0;
  double angle_lo = 0.0;
  double angle_hi = 0.0;
};

/// phi_max is 0 when y sees nothing of the lateral surface.
Strip stripOf(const Emitter& e, const dvec3& y) {
  Strip s;
  const dvec3 from = y - e.position;
  s.along = glm::dot(from, e.axis);
  const dvec3 radial = from - s.along * e.axis;
  s.rho = glm::length(radial);
  if (!(s.rho > e.radius)) return s;
  s.outward = radial / s.rho;
  s.phi_max = std::acos(e.radius / s.rho);
  s.angle_lo = std::atan2(-e.half_length - s.along, s.rho);
  s.angle_hi = std::atan2(e.half_length - s.along, s.rho);
  return s;
}

double stripDensity(const Emitter& e, const Strip& s, double along) {
  if (!(s.phi_max > 0.0)) return 0.0;
  const double off = along - s.along;
  const double per_length = s.rho / ((s.angle_hi - s.angle_lo) * (s.rho * s.rho + off * off));
  return per_length / (2.0 * s.phi_max * e.radius);
}

LightPoint sampleStrip(const Emitter& e, const dvec3& y, const dvec2& u) {
  const Strip s = stripOf(e, y);
  if (!(s.phi_max > 0.0)) return {};
  const double angle = s.angle_lo + u.x * (s.angle_hi - s.angle_lo);
  const double along = std::clamp(s.along + s.rho * std::tan(angle), -e.half_length, e.half_length);
  const double phi = (2.0 * u.y - 1.0) * s.phi_max;
  const dvec3 side = glm::cross(e.axis, s.outward);
  const dvec3 normal = std::cos(phi) * s.outward + std::sin(phi) * side;
  return {e.position + along * e.axis + e.radius * normal, normal, stripDensity(e, s, along)};
}

dvec3 uniformInTriangle(const dvec3& a, const dvec3& b, const dvec3& c, const dvec2& u) {
  // Folding the unit square along its diagonal (Heitz 2019 is smoother, but this has no root).
  const bool upper = u.x + u.y > 1.0;
  const double s = upper ? 1.0 - u.x : u.x;
  const double t = upper ? 1.0 - u.y : u.y;
  return a + s * (b - a) + t * (c - a);
}

/// Picks a triangle by area; u is stretched to its place within that triangle's share.
std::size_t pickTriangle(const Emitter& e, double& u) {
  const double target = u * e.area_sums.back();
  const auto it = std::upper_bound(e.area_sums.begin(), e.area_sums.end() - 1, target);
  const auto i = static_cast<std::size_t>(it - e.area_sums.begin());
  const double before = i == 0 ? 0.0 : e.area_sums[i - 1];
  u = std::clamp((target - before) / (e.area_sums[i] - before), 0.0, 1.0);
  return i;
}

dvec3 aroundAxis(const dvec3& axis, double phi) {
  dvec3 t(0.0);
  dvec3 b(0.0);
  orthonormalBasis(axis, t, b);
  return std::cos(phi) * t + std::sin(phi) * b;
}

/// Uniform over the emitting surface.
LightPoint sampleArea(const LightShape& light, dvec2 u) {
  const Emitter& e = light.emitter();
  const double density = 1.0 / e.area;
  const double phi = 2.0 * kPi * u.y;
  if (e.kind == EmitterKind::sphere) {
    const double z = 1.0 - 2.0 * u.x;
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    const dvec3 n(r * std::cos(phi), r * std::sin(phi), z);
    return {e.position + e.radius * n, n, density};
  }
  if (e.kind == EmitterKind::tube) {
    const dvec3 n = aroundAxis(e.axis, phi);
    return {e.position + (2.0 * u.x - 1.0) * e.half_length * e.axis + e.radius * n, n, density};
  }
  if (e.kind == EmitterKind::mesh) {
    const std::size_t i = pickTriangle(e, u.x);
    return {uniformInTriangle(e.corners[3 * i], e.corners[3 * i + 1], e.corners[3 * i + 2], u),
            e.triangle_normals[i], density};
  }
  if (e.disk) {
    return {e.position + e.radius * std::sqrt(u.x) * aroundAxis(e.normal, phi), e.normal, density};
  }
  if (light.isRectangle()) {
    return {light.corner() + u.x * light.edgeX() + u.y * light.edgeY(), e.normal, density};
  }
  const uvec3 t = e.outline_triangles[pickTriangle(e, u.x)];
  return {uniformInTriangle(e.outline[t.x], e.outline[t.y], e.outline[t.z], u), e.normal, density};
}

}  // namespace

LightPoint sampleLight(const LightShape& light, const dvec3& y, const dvec2& u) {
  const Emitter& e = light.emitter();
  if (e.kind == EmitterKind::point) return {e.position, dvec3(0.0), 1.0};
  if (behind(e, y)) return {};
  if (byCone(e, y)) return sampleCone(e, y, u);
  if (e.kind == EmitterKind::tube && e.table == nullptr) return sampleStrip(e, y, u);
  if (bySolidAngle(light, y)) {
    const SphericalRectangle seen = sphericalRectangle(light, y);
    if (!(seen.solidAngle() > 0.0)) return {};
    const dvec3 point = seen.sample(u);
    return {point, e.normal, perArea(1.0 / seen.solidAngle(), y, point, e.normal)};
  }
  return sampleArea(light, u);
}

double lightDensity(const LightShape& light, const dvec3& y, const dvec3& point,
                    const dvec3& normal) {
  const Emitter& e = light.emitter();
  if (e.kind == EmitterKind::point || behind(e, y)) return 0.0;
  if (byCone(e, y)) {
    return perArea(1.0 / (2.0 * kPi * coneOf(e, y).one_minus_cos), y, point, normal);
  }
  if (e.kind == EmitterKind::tube && e.table == nullptr) {
    return stripDensity(e, stripOf(e, y), glm::dot(point - e.position, e.axis));
  }
  if (bySolidAngle(light, y)) {
    const double solid_angle = sphericalRectangle(light, y).solidAngle();
    return solid_angle > 0.0 ? perArea(1.0 / solid_angle, y, point, normal) : 0.0;
  }
  return 1.0 / e.area;
}

}  // namespace soffit::reference

// SPDX-License-Identifier: MIT
#include "core/reference/light_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::reference {
namespace {

using light::Emitter;
using light::EmitterKind;

/// The two roots of a t^2 + 2 b t + c = 0, without cancellation; none when they are complex.
int solveQuadratic(double a, double b, double c, std::array<double, 2>& t) {
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0.0) || a == 0.0) return 0;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  t = {q / a, q != 0.0 ? c / q : 0.0};
  if (t[0] > t[1]) std::swap(t[0], t[1]);
  return 2;
}

std::shared_ptr<const geometry::RayCaster> casterOf(const Emitter& e) {
  std::vector<vec3> positions(e.corners.begin(), e.corners.end());
  std::vector<uvec3> triangles;
  for (std::uint32_t i = 0; i < positions.size(); i += 3) triangles.emplace_back(i, i + 1, i + 2);
  return std::make_shared<const geometry::RayCaster>(positions, triangles);
}

geometry::Ray toRay(const Line& line, double t_min, double t_max) {
  geometry::Ray ray;
  ray.origin = vec3(line.origin);
  ray.direction = vec3(line.direction);
  ray.t_min = static_cast<float>(t_min);
  ray.t_max = t_max < 1e30 ? static_cast<float>(t_max) : std::numeric_limits<float>::infinity();
  return ray;
}

bool within(double t, double t_max) {
  return t > 0.0 && t < t_max;
}

}  // namespace

LightShape::LightShape(const Emitter& emitter) : emitter_(&emitter) {
  const dvec3 lo(emitter.bounds.lo);
  const dvec3 hi(emitter.bounds.hi);
  center_ = 0.5 * (lo + hi);
  radius_ = 0.5 * glm::length(hi - lo);
  if (emitter.kind == EmitterKind::mesh) mesh_ = casterOf(emitter);
  if (emitter.kind == EmitterKind::planar && emitter.outline.size() == 4) {
    const auto& p = emitter.outline;
    corner_ = p[0];
    edge_x_ = p[1] - p[0];
    edge_y_ = p[3] - p[0];
    const double tolerance =
        1e-9 * emitter.area;  // round-off of corners a few sizes from the origin
    const dvec3 gap = p[2] - (p[1] + edge_y_);
    rectangle_ = std::abs(glm::dot(edge_x_, edge_y_)) < tolerance && glm::dot(gap, gap) < tolerance;
  }
}

bool LightShape::missesBounds(const Line& line, double t_max) const {
  const dvec3 to = center_ - line.origin;
  const double along = glm::dot(to, line.direction);
  const double distance_squared = glm::dot(to, to) - along * along;
  const double slack = radius_ * radius_ * (1.0 + 1e-6) + 1e-12 * glm::dot(to, to);
  return distance_squared > slack || along < -radius_ || along - radius_ > t_max;
}

void LightShape::cross(const Line& line, double t_max, std::vector<Crossing>& out) const {
  if (emitter_->kind == EmitterKind::point || missesBounds(line, t_max)) return;
  if (emitter_->kind == EmitterKind::mesh) return crossMesh(line, t_max, out);
  std::array<Crossing, 2> crossings;
  const int n = crossExact(line, t_max, crossings);
  out.insert(out.end(), crossings.begin(), crossings.begin() + n);
}

int LightShape::crossExact(const Line& line, double t_max, std::array<Crossing, 2>& out) const {
  if (emitter_->kind == EmitterKind::sphere) return crossSphere(line, t_max, out);
  if (emitter_->kind == EmitterKind::tube) return crossTube(line, t_max, out);
  return crossPlane(line, t_max, out);
}

bool LightShape::insideOutline(const dvec3& p) const {
  const Emitter& e = *emitter_;
  if (e.disk) {
    const dvec3 d = p - e.position;
    return glm::dot(d, d) <= e.radius * e.radius;
  }
  const dvec3 d = p - corner_;
  if (rectangle_) {
    const double x = glm::dot(d, edge_x_);
    const double y = glm::dot(d, edge_y_);
    return x >= 0.0 && y >= 0.0 && x <= glm::dot(edge_x_, edge_x_) &&
           y <= glm::dot(edge_y_, edge_y_);
  }
  return std::any_of(e.outline_triangles.begin(), e.outline_triangles.end(), [&](const uvec3& t) {
    const dvec3& a = e.outline[t.x];
    const dvec3& b = e.outline[t.y];
    const dvec3& c = e.outline[t.z];
    return glm::dot(glm::cross(b - a, p - a), e.normal) >= 0.0 &&
           glm::dot(glm::cross(c - b, p - b), e.normal) >= 0.0 &&
           glm::dot(glm::cross(a - c, p - c), e.normal) >= 0.0;
  });
}

int LightShape::crossPlane(const Line& line, double t_max, std::array<Crossing, 2>& out) const {
  const Emitter& e = *emitter_;
  const double approach = glm::dot(line.direction, e.normal);
  if (approach == 0.0) return 0;
  const dvec3& anchor = e.disk ? e.position : e.outline[0];
  const double t = glm::dot(anchor - line.origin, e.normal) / approach;
  if (!within(t, t_max) || !insideOutline(line.origin + t * line.direction)) return 0;
  out[0] = {.t = t, .normal = e.normal};
  return 1;
}

int LightShape::crossSphere(const Line& line, double t_max, std::array<Crossing, 2>& out) const {
  const Emitter& e = *emitter_;
  const dvec3 from = line.origin - e.position;
  std::array<double, 2> t{};
  const double c = glm::dot(from, from) - e.radius * e.radius;
  const int n = solveQuadratic(1.0, glm::dot(from, line.direction), c, t);
  int found = 0;
  for (int i = 0; i < n; ++i) {
    if (!within(t[i], t_max)) continue;
    out[found++] = {.t = t[i], .normal = (from + t[i] * line.direction) / e.radius};
  }
  return found;
}

int LightShape::crossTube(const Line& line, double t_max, std::array<Crossing, 2>& out) const {
  const Emitter& e = *emitter_;
  const dvec3 from = line.origin - e.position;
  const double from_along = glm::dot(from, e.axis);
  const double dir_along = glm::dot(line.direction, e.axis);
  const dvec3 p = from - from_along * e.axis;
  const dvec3 d = line.direction - dir_along * e.axis;
  std::array<double, 2> t{};
  const double c = glm::dot(p, p) - e.radius * e.radius;
  const int n = solveQuadratic(glm::dot(d, d), glm::dot(p, d), c, t);
  int found = 0;
  for (int i = 0; i < n; ++i) {
    if (!within(t[i], t_max)) continue;
    if (std::abs(from_along + t[i] * dir_along) > e.half_length) continue;
    out[found++] = {.t = t[i], .normal = (p + t[i] * d) / e.radius};
  }
  return found;
}

void LightShape::crossMesh(const Line& line, double t_max, std::vector<Crossing>& out) const {
  double t_min = 0.0;
  for (;;) {
    const geometry::Hit hit = mesh_->closest(toRay(line, t_min, t_max));
    if (!hit.valid()) return;
    out.push_back({.t = hit.t, .normal = emitter_->triangle_normals[hit.triangle]});
    if (emitter_->casts_shadow) return;
    // The next float: a surface that is crossed once must not be found twice, and coincident
    // ones are rare.
    t_min = std::nextafter(hit.t, std::numeric_limits<float>::infinity());
  }
}

double LightShape::capDistance(const Line& line, double t_max) const {
  const Emitter& e = *emitter_;
  const double approach = glm::dot(line.direction, e.axis);
  if (approach == 0.0) return kInfinity;
  double nearest = kInfinity;
  for (const double end : {-e.half_length, e.half_length}) {
    const dvec3 middle = e.position + end * e.axis;
    const double t = glm::dot(middle - line.origin, e.axis) / approach;
    const dvec3 off = line.origin + t * line.direction - middle;
    if (within(t, t_max) && glm::dot(off, off) <= e.radius * e.radius)
      nearest = std::min(nearest, t);
  }
  return nearest;
}

double LightShape::bodyDistance(const Line& line, double t_max) const {
  if (emitter_->kind == EmitterKind::point || missesBounds(line, t_max)) return kInfinity;
  if (emitter_->kind == EmitterKind::mesh) {
    const geometry::Hit hit = mesh_->closest(toRay(line, 0.0, t_max));
    return hit.valid() ? hit.t : kInfinity;
  }
  std::array<Crossing, 2> crossings;
  const int n = crossExact(line, t_max, crossings);
  double nearest = emitter_->kind == EmitterKind::tube ? capDistance(line, t_max) : kInfinity;
  for (int i = 0; i < n; ++i) nearest = std::min(nearest, crossings[i].t);
  return nearest;
}

bool LightShape::shadesItself(const dvec3& origin, const dvec3& point, const dvec3& normal) const {
  if (mesh_ == nullptr || !emitter_->casts_shadow) return false;
  const dvec3 to = point - origin;
  const dvec3 outward = glm::dot(normal, to) < 0.0 ? normal : -normal;
  const dvec3 target(geometry::offsetOrigin(vec3(point), vec3(outward)));
  geometry::Ray ray;
  ray.origin = vec3(origin);
  ray.direction = vec3(target - origin);
  ray.t_max = 1.0F;
  return mesh_->occluded(ray);
}

}  // namespace soffit::reference

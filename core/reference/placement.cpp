// SPDX-License-Identifier: MIT
#include "core/reference/placement.h"

#include "core/base/parallel.h"
#include "core/geometry/ray_caster.h"

#include <algorithm>
#include <cmath>

namespace soffit::reference {
namespace {

struct Triangle {
  dvec3 a, b, c;
};

Triangle triangleOf(const geometry::Mesh& mesh, const uvec3& t) {
  return {dvec3(mesh.positions[t.x]), dvec3(mesh.positions[t.y]), dvec3(mesh.positions[t.z])};
}

/// Whether p is in the triangle's box grown by kOnSurface: cheap, and most are not.
bool nearBox(const geometry::Mesh& mesh, const uvec3& t, const vec3& p) {
  constexpr float kGrow = 1.01F * static_cast<float>(kOnSurface);
  const vec3& a = mesh.positions[t.x];
  const vec3& b = mesh.positions[t.y];
  const vec3& c = mesh.positions[t.z];
  for (int k = 0; k < 3; ++k) {
    if (std::min({a[k], b[k], c[k]}) - kGrow > p[k]) return false;
    if (std::max({a[k], b[k], c[k]}) + kGrow < p[k]) return false;
  }
  return true;
}

/// Squared distance of p to the segment from a to b.
double toSegment(const dvec3& p, const dvec3& a, const dvec3& b) {
  const dvec3 d = b - a;
  const double length_squared = glm::dot(d, d);
  const double t =
      length_squared > 0.0 ? std::clamp(glm::dot(p - a, d) / length_squared, 0.0, 1.0) : 0.0;
  const dvec3 off = p - (a + t * d);
  return glm::dot(off, off);
}

/// Distance of p to a triangle with unit normal n.
double distanceTo(const dvec3& p, const Triangle& t, const dvec3& n) {
  const bool above = glm::dot(glm::cross(t.b - t.a, p - t.a), n) >= 0.0 &&
                     glm::dot(glm::cross(t.c - t.b, p - t.b), n) >= 0.0 &&
                     glm::dot(glm::cross(t.a - t.c, p - t.c), n) >= 0.0;
  if (above) return std::abs(glm::dot(p - t.a, n));
  return std::sqrt(
      std::min({toSegment(p, t.a, t.b), toSegment(p, t.b, t.c), toSegment(p, t.c, t.a)}));
}

dvec3 place(const geometry::Mesh& mesh, const scene::Sensor& sensor) {
  const dvec3 start = sensor.position - mesh.origin;
  dvec3 p = start;
  for (const uvec3& indices : mesh.triangles) {
    if (!nearBox(mesh, indices, vec3(start))) continue;
    const Triangle t = triangleOf(mesh, indices);
    const dvec3 area = glm::cross(t.b - t.a, t.c - t.a);
    const double length = glm::length(area);
    if (!(length > 0.0)) continue;
    const dvec3 n = area / length;
    if (distanceTo(start, t, n) > kOnSurface) continue;
    const double height = glm::dot(p - t.a, n);
    const double along = glm::dot(sensor.normal, n);
    const double side = std::abs(along) > 1e-6 ? along : height;
    const dvec3 outward = side < 0.0 ? -n : n;
    const dvec3 on_plane = p - height * n;
    const double step =
        glm::length(dvec3(geometry::offsetOrigin(vec3(on_plane), vec3(outward)) - vec3(on_plane)));
    // Only outwards: a sensor that is already clear of the surface stays where it is.
    if (glm::dot(p - t.a, outward) < step) p = on_plane + step * outward;
  }
  return p;
}

}  // namespace

std::vector<dvec3> placeSensors(const geometry::Mesh& mesh,
                                std::span<const scene::Sensor> sensors) {
  std::vector<dvec3> out(sensors.size());
  parallelFor(sensors.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) out[i] = place(mesh, sensors[i]);
  });
  return out;
}

}  // namespace soffit::reference

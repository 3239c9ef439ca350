// SPDX-License-Identifier: MIT
#include "core/light/emitter_shapes.h"

#include "core/light/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace soffit::light {
namespace {

bool isSize(double length) {
  return std::isfinite(length) && length > 0.0;
}

Error sizeError(const char* place, double found) {
  return {fmt::format("shape.{}", place),
          fmt::format("expected sizes above 0 (after scale) and finite, found {}", found),
          "Give the shape a size, or use \"point\""};
}

/// Box of a point that holds it in spite of the rounding to float.
void addRounded(Box& box, const dvec3& p) {
  const float inf = std::numeric_limits<float>::infinity();
  for (int k = 0; k < 3; ++k) {
    const auto f = static_cast<float>(p[k]);
    box.lo[k] = std::min(box.lo[k], std::nextafter(f, -inf));
    box.hi[k] = std::max(box.hi[k], std::nextafter(f, inf));
  }
}

/// half_size is the half extent along x, y, z.
void addExtent(Box& box, const dvec3& center, const dvec3& half_size) {
  addRounded(box, center - half_size);
  addRounded(box, center + half_size);
}

/// Extent of a disk with unit normal n along the axes: radius sqrt(1 - n_k^2).
dvec3 diskExtent(const dvec3& n, double radius) {
  return radius * glm::sqrt(glm::max(dvec3(1.0) - n * n, dvec3(0.0)));
}

struct Placer {
  double scale;
  Emitter& e;

  [[nodiscard]] dvec3 world(const dvec3& local) const {
    return e.position + e.world_from_light * (scale * local);
  }

  Result<void> operator()(const PointShape& /*shape*/) const {
    e.kind = EmitterKind::point;
    e.normal = e.world_from_light * dvec3(0.0, 0.0, -1.0);
    addRounded(e.bounds, e.position);
    return {};
  }

  Result<void> operator()(const Rectangle& shape) const {
    const double hx = 0.5 * scale * shape.width;
    const double hy = 0.5 * scale * shape.height;
    if (!isSize(hx) || !isSize(hy)) return sizeError("rectangle", 2.0 * (isSize(hx) ? hy : hx));
    placeOutline({{-hx, -hy}, {hx, -hy}, {hx, hy}, {-hx, hy}}, {{0, 1, 2}, {0, 2, 3}});
    return {};
  }

  Result<void> operator()(const Polygon& shape) const {
    std::vector<dvec2> scaled = shape.outline;
    for (dvec2& p : scaled) p *= scale;
    Result<Outline> outline = makeOutline(scaled);
    if (!outline) {
      Error error = outline.error();
      error.place = "shape.polygon";
      return error;
    }
    placeOutline(outline->corners, outline->triangles);
    return {};
  }

  Result<void> operator()(const Disk& shape) const {
    e.kind = EmitterKind::planar;
    e.disk = true;
    e.radius = scale * shape.radius;
    if (!isSize(e.radius)) return sizeError("disk", e.radius);
    e.normal = e.world_from_light * dvec3(0.0, 0.0, -1.0);
    e.area = kPi * e.radius * e.radius;
    addExtent(e.bounds, e.position, diskExtent(e.normal, e.radius));
    return {};
  }

  Result<void> operator()(const Sphere& shape) const {
    e.kind = EmitterKind::sphere;
    e.radius = scale * shape.radius;
    if (!isSize(e.radius)) return sizeError("sphere", e.radius);
    e.area = 4.0 * kPi * e.radius * e.radius;
    addExtent(e.bounds, e.position, dvec3(e.radius));
    return {};
  }

  Result<void> operator()(const Tube& shape) const {
    e.kind = EmitterKind::tube;
    e.radius = scale * shape.radius;
    e.half_length = 0.5 * scale * shape.length;
    if (!isSize(e.radius)) return sizeError("tube", e.radius);
    if (!isSize(e.half_length)) return sizeError("tube", 2.0 * e.half_length);
    e.axis = e.world_from_light * dvec3(1.0, 0.0, 0.0);
    e.area = 2.0 * kPi * e.radius * 2.0 * e.half_length;  // lateral surface only
    addExtent(e.bounds, e.position,
              glm::abs(e.axis) * e.half_length + diskExtent(e.axis, e.radius));
    return {};
  }

  Result<void> operator()(const MeshShape& shape) const {
    e.kind = EmitterKind::mesh;
    const std::string place = fmt::format("shape.mesh {}", shape.file);
    if (shape.mesh == nullptr) {
      return Error{place, "the mesh is not loaded", "Check the file's name and format"};
    }
    const geometry::Mesh& mesh = *shape.mesh;
    for (const uvec3& t : mesh.triangles) {
      addTriangle(corner(mesh, t.x), corner(mesh, t.y), corner(mesh, t.z));
    }
    if (!(e.area > 0.0) || !std::isfinite(e.area)) {
      return Error{place, "expected triangles with a finite area, found none",
                   "Export the mesh again, with faces"};
    }
    return {};
  }

 private:
  [[nodiscard]] dvec3 corner(const geometry::Mesh& mesh, std::uint32_t index) const {
    return world(mesh.origin + dvec3(mesh.positions[index]));
  }

  void addTriangle(const dvec3& a, const dvec3& b, const dvec3& c) const {
    const dvec3 twice_area = glm::cross(b - a, c - a);
    const double length = glm::length(twice_area);
    if (!(length > 0.0)) return;
    e.corners.insert(e.corners.end(), {a, b, c});
    e.triangle_normals.push_back(twice_area / length);
    e.triangle_areas.push_back(0.5 * length);
    e.area += 0.5 * length;
    e.area_sums.push_back(e.area);
    for (const dvec3& p : {a, b, c}) addRounded(e.bounds, p);
  }

  /// corners and triangles counter-clockwise in the local x, y plane, corners already scaled.
  void placeOutline(const std::vector<dvec2>& corners, const std::vector<uvec3>& triangles) const {
    e.kind = EmitterKind::planar;
    e.normal = e.world_from_light * dvec3(0.0, 0.0, -1.0);
    const auto n = static_cast<std::uint32_t>(corners.size());
    // The emitting side is -z: what is counter-clockwise from above is clockwise from there.
    for (std::uint32_t i = 0; i < n; ++i) {
      const dvec2& p = corners[n - 1 - i];
      e.outline.push_back(e.position + e.world_from_light * dvec3(p, 0.0));
      addRounded(e.bounds, e.outline.back());
    }
    for (const uvec3& t : triangles) {
      e.outline_triangles.emplace_back(n - 1 - t.x, n - 1 - t.z, n - 1 - t.y);
      const dvec2 u = corners[t.y] - corners[t.x];
      const dvec2 v = corners[t.z] - corners[t.x];
      e.area += 0.5 * std::abs(u.x * v.y - u.y * v.x);
      e.area_sums.push_back(e.area);
    }
  }
};

}  // namespace

Result<void> placeShape(const Shape& shape, double scale, Emitter& emitter) {
  return std::visit(Placer{scale, emitter}, shape);
}

}  // namespace soffit::light

// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/shapes.h"
#include "core/prt/bounces.h"
#include "core/prt/direct_transfer.h"
#include "core/prt/shadow_pass.h"
#include "core/prt/vertex_receivers.h"
#include "core/sh/projection.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Small scenes for the tests of prt.
namespace soffit::prt::testing {

inline scene::Material matte(const vec3& reflectance) {
  scene::Material m;
  m.diffuse = dvec3(reflectance);
  return m;
}

/// A scene that grows part by part, each with a material of its own.
struct Builder {
  geometry::Mesh mesh;
  std::vector<scene::Material> materials;

  Builder& add(const geometry::Mesh& part, const scene::Material& material) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
    if (part.uvs.empty()) {
      mesh.uvs.resize(mesh.positions.size(), vec2(0.0F));
    } else {
      mesh.uvs.insert(mesh.uvs.end(), part.uvs.begin(), part.uvs.end());
    }
    for (const uvec3& t : part.triangles) {
      mesh.triangles.push_back(t + first);
      mesh.material_of.push_back(static_cast<std::uint32_t>(materials.size()));
      mesh.object_of.push_back(static_cast<std::uint32_t>(materials.size()));
    }
    mesh.materials.push_back("m" + std::to_string(materials.size()));
    mesh.objects.push_back("o" + std::to_string(materials.size()));
    materials.push_back(material);
    return *this;
  }
  [[nodiscard]] std::shared_ptr<const Surfaces> surfaces(std::vector<vec3> inside = {}) const {
    return makeSurfaces(std::make_shared<const geometry::Mesh>(mesh), materials, inside);
  }
};

inline geometry::Mesh moved(geometry::Mesh mesh, const vec3& by) {
  for (vec3& p : mesh.positions) p += by;
  return mesh;
}

/// Turned about the world's zero, so that nothing is parallel to an axis.
inline geometry::Mesh turned(geometry::Mesh mesh, const dvec3& degrees_xyz) {
  const dmat3 r = rotationXyz(degrees_xyz);
  for (vec3& p : mesh.positions) p = vec3(r * dvec3(p));
  for (vec3& n : mesh.normals) n = vec3(r * dvec3(n));
  return mesh;
}

/// One triangle pair without normals from corners in order.
inline geometry::Mesh quad(const vec3& corner, const vec3& u, const vec3& v) {
  geometry::Mesh mesh;
  mesh.positions = {corner, corner + u, corner + u + v, corner + v};
  mesh.normals.assign(4, glm::normalize(glm::cross(u, v)));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A box whose six faces are of 2 n^2 triangles each.
inline geometry::Mesh fineBox(const vec3& lo, const vec3& hi, int n) {
  const vec3 half = 0.5F * (hi - lo);
  const vec3 turns[6] = {{0, 0, 0}, {180, 0, 0}, {90, 0, 0}, {-90, 0, 0}, {0, 90, 0}, {0, -90, 0}};
  geometry::Mesh all;
  for (const vec3& turn : turns) {
    geometry::Mesh face =
        turned(moved(geometry::makeRectangle(2, 2, n, n), {0, 0, 1}), dvec3(turn));
    for (vec3& p : face.positions) p = 0.5F * (lo + hi) + half * p;
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), face.positions.begin(), face.positions.end());
    all.normals.insert(all.normals.end(), face.normals.begin(), face.normals.end());
    for (const uvec3& t : face.triangles) all.triangles.push_back(t + first);
  }
  return all;
}

/// A floor of 4 x 4 m of 2 n^2 triangles with a block of 1 x 1 x 1.2 m over it, `gap` above.
inline Builder blockOnFloor(int n, const vec3& floor, const vec3& block, float gap = 0.01F) {
  Builder b;
  b.add(geometry::makeRectangle(4, 4, n, n), matte(floor));
  b.add(geometry::makeBox({-0.5F, -0.5F, gap}, {0.5F, 0.5F, gap + 1.2F}), matte(block));
  return b;
}

/// Single points, for closed forms.
inline Receivers pointReceivers(const std::vector<vec3>& positions, const vec3& normal) {
  Receivers r;
  r.positions = positions;
  r.normals.assign(positions.size(), normal);
  r.facing = r.normals;
  r.reflectance.assign(positions.size(), vec3(0.0F));
  r.areas.assign(positions.size(), 1.0F);
  return r;
}

/// E of a row under light coefficients, lux.
inline double illuminance(const TransferRows& rows, std::size_t i, const sh::Coefficients& light,
                          std::size_t channel = 0) {
  const auto t = rows.vector(i, channel);
  double sum = 0.0;
  for (std::size_t k = 0; k < std::min(t.size(), light.size()); ++k) sum += light[k] * double{t[k]};
  return sum;
}

/// Even light of 1 cd/m^2 from everywhere: an open receiver has pi lux.
inline sh::Coefficients evenLight(int bands) {
  sh::Coefficients c(sh::coefficientCount(bands), 0.0);
  c[0] = 2.0 * std::sqrt(kPi);
  return c;
}

inline TransferRows shadowed(const Surfaces& surfaces, const Receivers& receivers,
                             const Directions& directions) {
  const auto pass = traceShadows(surfaces, receivers, directions).value();
  return shadowedTransfer(receivers, directions, pass.flags).value();
}

}  // namespace soffit::prt::testing

// SPDX-License-Identifier: MIT
#include "core/prt/surfaces.h"

#include "core/geometry/components.h"

#include <algorithm>
#include <utility>

namespace soffit::prt {
namespace {

/// Whether a solid holds another component: the middle of a few of its triangles.
bool holdsAnother(const geometry::Mesh& mesh, const geometry::Components& all, std::size_t index) {
  const geometry::Component& shell = all.list[index];
  const float margin = 1e-4F * shell.bounds.diagonal();
  for (std::size_t other = 0; other < all.list.size(); ++other) {
    const geometry::Component& o = all.list[other];
    // What reaches out of the shell's box is not held by it.
    if (other == index || !shell.bounds.contains(o.bounds.lo) ||
        !shell.bounds.contains(o.bounds.hi)) {
      continue;
    }
    const std::size_t step = std::max<std::size_t>(1, o.triangles.size() / 8);
    for (std::size_t k = 0; k < o.triangles.size(); k += step) {
      const uvec3& t = mesh.triangles[o.triangles[k]];
      const vec3 p = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0F;
      // What lies on the shell (a block's foot on the floor) says nothing.
      const vec3 gap = glm::min(p - shell.bounds.lo, shell.bounds.hi - p);
      if (std::min({gap.x, gap.y, gap.z}) > margin && geometry::contains(mesh, shell, p)) {
        return true;
      }
    }
  }
  return false;
}

std::vector<std::uint8_t> sidesOf(const geometry::Mesh& mesh, std::span<const vec3> inside,
                                  const daylight::Panes* panes) {
  std::vector<std::uint8_t> sides(mesh.triangles.size(), transfer::kBothSides);
  const auto glass = [&](std::uint32_t t) { return panes != nullptr && panes->isGlass(t); };
  const geometry::Components all = geometry::findComponents(mesh);
  for (std::size_t i = 0; i < all.list.size(); ++i) {
    const geometry::Component& c = all.list[i];
    if (!c.solid() || std::any_of(c.triangles.begin(), c.triangles.end(), glass)) continue;
    const auto holds = [&](const vec3& p) {
      return c.bounds.contains(p) && geometry::contains(mesh, c, p);
    };
    const bool room =
        std::any_of(inside.begin(), inside.end(), holds) || holdsAnother(mesh, all, i);
    const auto side = c.outward() != room ? transfer::kFront : transfer::kBack;
    for (const std::uint32_t t : c.triangles) sides[t] = side;
  }
  return sides;
}

/// Unit, on the face's side; the face's where the mesh says nothing.
vec3 cornerNormal(const geometry::Mesh& mesh, std::uint32_t vertex, const vec3& face) {
  if (mesh.normals.empty()) return face;
  const vec3 n = mesh.normals[vertex];
  const float length = glm::length(n);
  if (!(length > 0.0F)) return face;
  return glm::dot(n, face) < 0.0F ? -n / length : n / length;
}

void addTriangle(const geometry::Mesh& mesh, const uvec3& t, Surfaces& to) {
  const dvec3 a(mesh.positions[t.x]);
  const dvec3 n = glm::cross(dvec3(mesh.positions[t.y]) - a, dvec3(mesh.positions[t.z]) - a);
  const double length = glm::length(n);
  const vec3 face = length > 0.0 ? vec3(n / length) : vec3(0.0F);
  to.normals.push_back(face);
  to.areas.push_back(static_cast<float>(0.5 * length));
  for (int k = 0; k < 3; ++k) to.corner_normals.push_back(cornerNormal(mesh, t[k], face));
}

}  // namespace

const scene::Material& Surfaces::material(std::uint32_t triangle) const {
  static const scene::Material kDefault;
  if (triangle >= mesh->material_of.size()) return kDefault;
  const std::uint32_t index = mesh->material_of[triangle];
  return index < materials.size() ? materials[index] : kDefault;
}

std::shared_ptr<const Surfaces> makeSurfaces(std::shared_ptr<const geometry::Mesh> mesh,
                                             std::vector<scene::Material> materials,
                                             std::span<const vec3> inside) {
  auto surfaces = std::make_shared<Surfaces>();
  surfaces->panes = daylight::Panes::make(*mesh, materials);
  surfaces->caster = std::make_shared<const geometry::RayCaster>(
      daylight::opaqueCaster(*mesh, surfaces->panes.get()));
  for (const uvec3& t : mesh->triangles) addTriangle(*mesh, t, *surfaces);
  surfaces->sides = sidesOf(*mesh, inside, surfaces->panes.get());
  for (std::uint32_t t = 0; t < surfaces->sides.size(); ++t) {
    const bool glass = surfaces->panes != nullptr && surfaces->panes->isGlass(t);
    if (glass || surfaces->areas[t] <= 0.0F) surfaces->sides[t] = transfer::kNoSide;
  }
  surfaces->materials = std::move(materials);
  surfaces->mesh = std::move(mesh);
  return surfaces;
}

}  // namespace soffit::prt

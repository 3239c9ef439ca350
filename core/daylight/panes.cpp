// SPDX-License-Identifier: MIT
#include "core/daylight/panes.h"

#include <algorithm>

namespace soffit::daylight {
namespace {

/// All triangles, those that are not wanted collapsed to a point, which no ray meets: the numbers
/// of the others stay.
template <class Wanted>
std::vector<uvec3> only(const geometry::Mesh& mesh, const Wanted& wanted) {
  std::vector<uvec3> triangles = mesh.triangles;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (!wanted(i)) triangles[i] = uvec3(triangles[i].x);
  }
  return triangles;
}

bool glassAt(const geometry::Mesh& mesh, std::span<const scene::Material> materials,
             std::uint32_t triangle) {
  if (triangle >= mesh.material_of.size()) return false;
  const std::uint32_t m = mesh.material_of[triangle];
  return m < materials.size() && materials[m].glass.has_value();
}

}  // namespace

std::shared_ptr<const Panes> Panes::make(const geometry::Mesh& mesh,
                                         std::span<const scene::Material> materials) {
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (glassAt(mesh, materials, i)) {
      return std::shared_ptr<const Panes>(new Panes(mesh, materials));
    }
  }
  return nullptr;
}

Panes::Panes(const geometry::Mesh& mesh, std::span<const scene::Material> materials)
    : caster_(mesh.positions,
              only(mesh, [&](std::uint32_t i) { return glassAt(mesh, materials, i); })) {
  std::vector<std::uint32_t> slab_of_material(materials.size(), kNone);
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (!materials[m].glass) continue;
    slab_of_material[m] = static_cast<std::uint32_t>(slabs_.size());
    slabs_.emplace_back(*materials[m].glass);
  }
  slab_of_.assign(mesh.triangles.size(), kNone);
  normals_.assign(mesh.triangles.size(), vec3(0.0F));
  centers_ = normals_;
  areas_.assign(mesh.triangles.size(), 0.0F);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!glassAt(mesh, materials, i)) continue;
    const scene::Glass& glass = *materials[mesh.material_of[i]].glass;
    slab_of_[i] = slab_of_material[mesh.material_of[i]];
    triangles_.push_back(i);
    content_.insert(content_.end(), {double(i), glass.index, glass.transmittance});
    const uvec3& t = mesh.triangles[i];
    const dvec3 a(mesh.positions[t.x]);
    const dvec3 n = glm::cross(dvec3(mesh.positions[t.y]) - a, dvec3(mesh.positions[t.z]) - a);
    const double length = glm::length(n);
    if (length > 0.0) normals_[i] = vec3(n / length);
    areas_[i] = static_cast<float>(0.5 * length);
    centers_[i] = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0F;
  }
}

PaneCrossing Panes::crossing(const geometry::Hit& hit, const vec3& direction) const {
  const double cosine = glm::dot(dvec3(normals_[hit.triangle]), dvec3(direction));
  const Slab::Shares shares = slab(hit.triangle).at(cosine / glm::length(dvec3(direction)));
  return {hit.t, hit.triangle, shares.transmitted, shares.reflected};
}

bool Panes::next(const geometry::Ray& ray, PaneCrossing& out) const {
  const geometry::Hit hit = caster_.closest(ray);
  if (!hit.valid()) return false;
  out = crossing(hit, ray.direction);
  return true;
}

double Panes::transmittance(geometry::Ray ray) const {
  double share = 1.0;
  PaneCrossing at;
  while (share > 0.0 && next(ray, at)) {
    share *= at.transmitted;
    ray.t_min = beyond(at.t, ray.direction);
  }
  return share;
}

void Panes::attenuate(std::span<const geometry::Ray> rays, std::span<float> share) const {
  std::vector<geometry::Ray> open;
  std::vector<std::size_t> of;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (share[i] <= 0.0F) continue;
    open.push_back(rays[i]);
    of.push_back(i);
  }
  std::vector<geometry::Hit> hits(open.size());
  caster_.closest(open, hits);
  for (std::size_t k = 0; k < open.size(); ++k) {
    if (!hits[k].valid()) continue;
    const PaneCrossing first = crossing(hits[k], open[k].direction);
    open[k].t_min = beyond(first.t, open[k].direction);
    share[of[k]] *= static_cast<float>(first.transmitted * transmittance(open[k]));
  }
}

geometry::RayCaster opaqueCaster(const geometry::Mesh& mesh, const Panes* panes) {
  if (panes == nullptr) return {mesh.positions, mesh.triangles};
  return {mesh.positions, only(mesh, [&](std::uint32_t i) { return !panes->isGlass(i); })};
}

}  // namespace soffit::daylight

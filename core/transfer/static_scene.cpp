// SPDX-License-Identifier: MIT
#include "core/transfer/static_scene.h"

#include "core/base/parallel.h"
#include "core/geometry/components.h"
#include "core/geometry/convex_faces.h"
#include "core/transfer/charts.h"
#include "core/transfer/hemisphere.h"

#include <algorithm>
#include <utility>

namespace soffit::transfer {
namespace {

/// Whether a closed component is a room rather than a thing.
bool isRoom(const geometry::Mesh& mesh, const geometry::Components& components, std::size_t index,
            std::span<const vec3> inside) {
  const geometry::Component& c = components.list[index];
  if (components.list.size() == 1) return true;
  const auto holds = [&](const vec3& p) {
    return c.bounds.contains(p) && geometry::contains(mesh, c, p);
  };
  if (std::any_of(inside.begin(), inside.end(), holds)) return true;
  for (std::size_t other = 0; other < components.list.size(); ++other) {
    if (other == index) continue;
    const geometry::Component& o = components.list[other];
    // Whatever reaches out of the shell's box is not held by it.
    if (o.bounds.lo.x < c.bounds.lo.x || o.bounds.lo.y < c.bounds.lo.y ||
        o.bounds.lo.z < c.bounds.lo.z || o.bounds.hi.x > c.bounds.hi.x ||
        o.bounds.hi.y > c.bounds.hi.y || o.bounds.hi.z > c.bounds.hi.z) {
      continue;
    }
    // Centres of a few triangles; those that lie on the shell itself (a block's foot on the
    // floor) say nothing. What only dips into the shell with less than half of its area, as a
    // picture's edge into its frame, is not held either: the frame would be lit from inside.
    const float margin = 1e-4F * c.bounds.diagonal();
    const std::size_t step = std::max<std::size_t>(1, o.triangles.size() / 16);
    float held = 0.0F;
    float area = 0.0F;
    for (std::size_t k = 0; k < o.triangles.size(); k += step) {
      const uvec3& t = mesh.triangles[o.triangles[k]];
      const vec3& a = mesh.positions[t.x];
      const vec3 p = (a + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0F;
      const vec3 gap = glm::min(p - c.bounds.lo, c.bounds.hi - p);
      if (std::min({gap.x, gap.y, gap.z}) <= margin) continue;
      const float own = glm::length(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a));
      area += own;
      if (holds(p)) held += own;
    }
    if (held > 0.5F * area) return true;
  }
  return false;
}

std::vector<std::uint8_t> sidesOf(const geometry::Mesh& mesh,
                                  const geometry::Components& components,
                                  std::span<const vec3> inside, const daylight::Panes* panes) {
  std::vector<std::uint8_t> sides(mesh.triangles.size(), kBothSides);
  const auto glass = [&](std::uint32_t t) { return panes != nullptr && panes->isGlass(t); };
  for (std::size_t i = 0; i < components.list.size(); ++i) {
    const geometry::Component& c = components.list[i];
    if (!c.solid() || std::any_of(c.triangles.begin(), c.triangles.end(), glass) ||
        isRoom(mesh, components, i, inside)) {
      continue;
    }
    for (const std::uint32_t t : c.triangles) sides[t] = c.outward() ? kFront : kBack;
  }
  if (panes != nullptr) {
    for (const std::uint32_t t : panes->triangles()) sides[t] = kNoSide;
  }
  return sides;
}

/// Toward the front; zero for a triangle without area.
vec3 unitNormal(const vec3& a, const vec3& b, const vec3& c) {
  const dvec3 n = glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a));
  const double length = glm::length(n);
  return length > 0.0 ? vec3(n / length) : vec3(0.0F);
}

/// One face as a blocker; its normal is zero when it has no area.
light::Blocker blockerOf(const geometry::ConvexFace& face, std::uint8_t sides) {
  light::Blocker blocker;
  blocker.corners = face.corners;
  blocker.count = static_cast<std::uint8_t>(face.count);
  if (sides == kBack) std::reverse(blocker.corners.begin(), blocker.corners.begin() + face.count);
  if (face.count == 3) blocker.corners[3] = blocker.corners[2];
  const auto& c = blocker.corners;
  const vec3 first = unitNormal(c[0], c[1], c[2]);
  blocker.normal = first != vec3(0.0F) ? first : unitNormal(c[0], c[2], c[3]);
  blocker.solid = sides != kBothSides;
  return blocker;
}

/// The mesh as few convex faces; a component's triangles share their sides. Those of glass go to
/// `pane_faces` instead.
light::Blockers blockersOf(const geometry::Mesh& mesh, const geometry::Components& components,
                           std::span<const std::uint8_t> sides, const daylight::Panes* panes,
                           std::vector<light::MaskBlocker>& pane_faces) {
  std::vector<light::Blocker> blockers;
  const geometry::ConvexFaces merged = geometry::mergeConvexFaces(mesh, components);
  // A face is of one material: all of it is glass or nothing.
  std::vector<std::uint8_t> glass(merged.faces.size(), 0);
  if (panes != nullptr) {
    for (const std::uint32_t t : panes->triangles()) glass[merged.face_of[t]] = 1;
  }
  for (std::size_t i = 0; i < merged.faces.size(); ++i) {
    const geometry::ConvexFace& face = merged.faces[i];
    if (glass[i] != 0) {
      const light::Blocker pane = blockerOf(face, kBothSides);
      if (pane.normal != vec3(0.0F)) pane_faces.push_back(light::maskBlocker(pane));
      continue;
    }
    // With glass in it, no triangle of the component is closed on one side.
    const auto& triangles = components.list[face.component].triangles;
    const auto opaque = std::find_if(triangles.begin(), triangles.end(), [&](std::uint32_t t) {
      return panes == nullptr || !panes->isGlass(t);
    });
    const light::Blocker blocker = blockerOf(face, sides[*opaque]);
    if (blocker.normal != vec3(0.0F)) blockers.push_back(blocker);
  }
  return light::Blockers(blockers);
}

/// Takes the sides of charts away whose every probe sees the void: 64 rays from each of the cells
/// of a coarse grid.
void dropVoidSides(StaticScene& scene) {
  constexpr std::size_t kProbes = 4000;
  const double cell = cellForCount(*scene.mesh, scene.sides, kProbes, 0.05);
  const Texels texels = makeTexels(*scene.mesh, scene.sides, cell, nullptr);
  const std::size_t slots = texels.slotCount();
  std::vector<std::uint8_t> sees(slots, 0);
  parallelFor(slots, 64, [&](std::size_t begin, std::size_t end) {
    HemisphereScratch scratch;
    HemisphereHits hits;
    for (std::size_t s = begin; s < end; ++s) {
      traceHemisphere(scene, texels, texels.receivers.position(s), texels.receivers.normal(s), 8, s,
                      0.0F, scratch, hits);
      sees[s] = hits.missed < 64 ? 1 : 0;
    }
  });
  std::vector<std::uint8_t> kept(texels.charts.charts.size(), kNoSide);
  for (std::size_t s = 0; s < slots; ++s) {
    if (sees[s] == 0) continue;
    const std::uint32_t chart = texels.charts.chart_of[texels.triangle[s]];
    const bool front =
        glm::dot(texels.receivers.normal(s), texels.charts.charts[chart].normal) > 0.0F;
    kept[chart] = static_cast<std::uint8_t>(kept[chart] | (front ? kFront : kBack));
  }
  for (std::size_t t = 0; t < scene.sides.size(); ++t) {
    scene.sides[t] = static_cast<std::uint8_t>(scene.sides[t] & kept[texels.charts.chart_of[t]]);
  }
}

}  // namespace

std::shared_ptr<const StaticScene> makeStaticScene(std::shared_ptr<const geometry::Mesh> mesh,
                                                   std::span<const vec3> inside,
                                                   std::shared_ptr<const daylight::Panes> panes) {
  const geometry::Components components = geometry::findComponents(*mesh);
  std::vector<std::uint8_t> sides = sidesOf(*mesh, components, inside, panes.get());
  std::vector<vec3> normals(mesh->triangles.size(), vec3(0.0F));
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const uvec3& t = mesh->triangles[i];
    normals[i] = unitNormal(mesh->positions[t.x], mesh->positions[t.y], mesh->positions[t.z]);
  }
  std::vector<light::MaskBlocker> pane_faces;
  light::Blockers blockers = blockersOf(*mesh, components, sides, panes.get(), pane_faces);
  const float size = mesh->bounds().diagonal();
  const geometry::Mesh& kept = *mesh;  // by the scene, from the next line on
  StaticScene scene{std::move(mesh),     daylight::opaqueCaster(kept, panes.get()),
                    std::move(blockers), std::move(normals),
                    std::move(sides),    std::min(1e-4F, 2e-5F * size),
                    std::move(panes),    std::move(pane_faces)};
  if (!kept.triangles.empty()) dropVoidSides(scene);
  return std::make_shared<const StaticScene>(std::move(scene));
}

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#include "ui/viewport/plain_preview.h"

#include <algorithm>

namespace soffit::ui {
namespace {

/// About what a dimly lit room has.
constexpr float kLux = 250.0F;

}  // namespace

PlainPreview makePlainPreview(const geometry::Mesh& mesh,
                              std::span<const scene::Material> materials) {
  auto shown = std::make_shared<DisplayMesh>();
  PlainPreview preview;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const uvec3& t = mesh.triangles[i];
    const vec3 corners[] = {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
    const vec3 cross = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const float length = glm::length(cross);
    if (length <= 0.0F) continue;
    const std::size_t material = mesh.material_of.empty() ? 0 : mesh.material_of[i];
    if (material < materials.size() && materials[material].glass) continue;
    const vec3 albedo =
        material < materials.size() ? vec3(materials[material].diffuse) : vec3(0.5F);
    for (const bool front : {true, false}) {
      const vec3 normal = (front ? 1.0F : -1.0F) / length * cross;
      const float shade = 0.65F + 0.2F * normal.z + 0.1F * normal.x + 0.05F * normal.y;
      for (const int k : {0, front ? 1 : 2, front ? 2 : 1}) {
        shown->indices.push_back(static_cast<std::uint32_t>(shown->positions.size()));
        shown->positions.push_back(corners[k]);
        shown->albedo.push_back(albedo);
        preview.lux.emplace_back(kLux * shade);
      }
    }
  }
  shown->parts.push_back({0, static_cast<std::uint32_t>(shown->indices.size()), nullptr});
  preview.mesh = std::move(shown);
  return preview;
}

}  // namespace soffit::ui

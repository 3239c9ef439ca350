// SPDX-License-Identifier: MIT
#include "core/scene/scene.h"

#include "core/scene/edits.h"

#include <cstddef>
#include <set>

namespace soffit::scene {

std::vector<light::Luminaire> resolveLayout(const Scene& scene, const Layout& layout) {
  std::vector<light::Luminaire> resolved = scene.luminaires;
  std::set<std::string> base_names;
  for (light::Luminaire& luminaire : resolved) {
    base_names.insert(luminaire.name);
    const auto edit = layout.edits.find(luminaire.name);
    if (edit != layout.edits.end()) luminaire = applyEdit(luminaire, edit->second);
  }
  for (const auto& [name, edit] : layout.edits) {
    if (base_names.contains(name)) continue;
    light::Luminaire own;
    own.name = name;
    resolved.push_back(applyEdit(own, edit));
  }
  return resolved;
}

std::vector<Sensor> sensorsOf(const WorkPlane& plane) {
  std::vector<Sensor> sensors;
  if (plane.nu < 1 || plane.nv < 1) return sensors;
  sensors.reserve(static_cast<std::size_t>(plane.nu) * static_cast<std::size_t>(plane.nv));
  const dvec3 normal = glm::normalize(glm::cross(plane.u, plane.v));
  for (int j = 0; j < plane.nv; ++j) {
    for (int i = 0; i < plane.nu; ++i) {
      const dvec3 along_u = plane.u * ((i + 0.5) / plane.nu);
      const dvec3 along_v = plane.v * ((j + 0.5) / plane.nv);
      sensors.push_back({plane.origin + along_u + along_v, normal});
    }
  }
  return sensors;
}

}  // namespace soffit::scene

// SPDX-License-Identifier: MIT
#include "ui/viewport/display_mesh.h"

#include <glm/gtc/matrix_access.hpp>

#include <array>

namespace soffit::ui {
namespace {

/// The picture's borders as planes (a, b, c, d), inside where a x + b y + c z + d >= 0; wider by a
/// few pixels, for the samples within pixels.
std::array<glm::vec4, 6> borders(const glm::mat4& clip) {
  constexpr float kWider = 1.02F;
  const glm::vec4 w = glm::row(clip, 3);
  return {kWider * w + glm::row(clip, 0),
          kWider * w - glm::row(clip, 0),
          kWider * w + glm::row(clip, 1),
          kWider * w - glm::row(clip, 1),
          w,
          w + glm::row(clip, 2)};
}

bool isOutside(const Box& box, const glm::vec4& plane) {
  const vec3 n(plane);
  const vec3 farthest(n.x > 0.0F ? box.hi.x : box.lo.x, n.y > 0.0F ? box.hi.y : box.lo.y,
                      n.z > 0.0F ? box.hi.z : box.lo.z);
  return glm::dot(n, farthest) + plane.w < 0.0F;
}

}  // namespace

std::vector<std::uint32_t> visibleIndices(const DisplayMesh& mesh, const glm::mat4& clip_from_scene,
                                          const glm::vec4& eye,
                                          std::vector<std::uint32_t>& counts) {
  const vec3 toward(eye);
  counts.clear();
  if (mesh.patches.empty()) {
    for (const DisplayMesh::Part& part : mesh.parts) counts.push_back(part.index_count);
    return mesh.indices;
  }
  const auto planes = borders(clip_from_scene);
  std::vector<std::uint32_t> seen;
  std::size_t patch = 0;
  for (const DisplayMesh::Part& part : mesh.parts) {
    const std::size_t before = seen.size();
    const std::uint32_t end = part.first_index + part.index_count;
    for (; patch < mesh.patches.size() && mesh.patches[patch].first_index < end; ++patch) {
      const DisplayMesh::Patch& p = mesh.patches[patch];
      if (p.planar && glm::dot(p.normal, toward) < eye.w * p.offset) continue;
      bool outside = false;
      for (const glm::vec4& plane : planes) outside = outside || isOutside(p.bounds, plane);
      if (outside) continue;
      const std::uint32_t* first = mesh.indices.data() + p.first_index;
      if (p.planar) {
        seen.insert(seen.end(), first, first + p.index_count);
        continue;
      }
      for (std::uint32_t k = 0; k < p.index_count; k += 3) {
        const vec3& a = mesh.positions[first[k]];
        const vec3 n =
            glm::cross(mesh.positions[first[k + 1]] - a, mesh.positions[first[k + 2]] - a);
        if (glm::dot(n, toward - eye.w * a) > 0.0F)
          seen.insert(seen.end(), first + k, first + k + 3);
      }
    }
    counts.push_back(static_cast<std::uint32_t>(seen.size() - before));
  }
  return seen;
}

}  // namespace soffit::ui

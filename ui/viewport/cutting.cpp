// SPDX-License-Identifier: MIT
#include "ui/viewport/cutting.h"

#include <array>
#include <cstddef>

namespace soffit::ui {
namespace {

/// Luminaires in a ceiling: rays start this much below them, m.
constexpr double kBelow = 0.05;
/// And so far beside them, too: a screen or a cupboard that reaches above the cut is no floor.
constexpr double kBeside = 0.4;

/// Whether a floor lies within `reach` m ahead, as far as rays beside a place tell.
bool isFloored(const dvec3& from, const dvec3& direction, double reach,
               const Surroundings& around) {
  for (const dvec2& side : {dvec2(0.0), dvec2(kBeside, 0.0), dvec2(-kBeside, 0.0),
                            dvec2(0.0, kBeside), dvec2(0.0, -kBeside)}) {
    const auto met = around.distance(from + dvec3(side, 0.0), direction);
    if (!met || *met >= reach) return false;
  }
  return true;
}

}  // namespace

std::vector<vec3> sectionLines(const geometry::Mesh& mesh, int axis, double place) {
  std::vector<vec3> lines;
  const auto at = static_cast<float>(place);
  for (const uvec3& t : mesh.triangles) {
    std::array<vec3, 2> ends{};
    std::size_t count = 0;
    for (int k = 0; k < 3 && count < 2; ++k) {
      const vec3& a = mesh.positions[t[k]];
      const vec3& b = mesh.positions[t[(k + 1) % 3]];
      // A corner in the plane counts as beyond it, so that each edge is met once or not at all.
      if ((a[axis] < at) == (b[axis] < at)) continue;
      vec3 p = a + (at - a[axis]) / (b[axis] - a[axis]) * (b - a);
      p[axis] = at;
      ends[count++] = p;
    }
    if (count == 2 && ends[0] != ends[1]) lines.insert(lines.end(), ends.begin(), ends.end());
  }
  return lines;
}

std::vector<bool> cutAway(const EmitterSet& luminaires, const ViewCamera& camera,
                          const Surroundings& around) {
  if (!camera.isParallel() || camera.cut_depth <= 0.0) return {};
  const bool plan = camera.mainAxis() == 2 && camera.forward.z < 0.0;
  std::vector<bool> away;
  for (const light::Emitter& e : luminaires.emitters()) {
    const dvec3 place = around.origin + e.position;
    const double before = camera.cut_depth - glm::dot(place - camera.position, camera.forward);
    if (before <= 0.0 || !plan) {
      away.push_back(before > 0.0);
      continue;
    }
    const dvec3 from = place + kBelow * camera.forward;
    away.push_back(isFloored(from, camera.forward, before - kBelow, around));
  }
  return away;
}

}  // namespace soffit::ui

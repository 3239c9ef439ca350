// SPDX-License-Identifier: MIT
#include "core/design/surface_receivers.h"

#include "core/math/rng.h"
#include "core/transfer/exposure.h"
#include "core/transfer/texels.h"

#include <algorithm>
#include <cmath>

namespace soffit::design {
namespace {

/// Sides of triangles that carry light, with running sums of their areas.
struct LitSides {
  struct Side {
    std::uint32_t triangle;
    bool front;
  };
  std::vector<Side> sides;
  std::vector<double> sums;
};

dvec3 areaVector(const geometry::Mesh& mesh, std::uint32_t triangle) {
  const uvec3& t = mesh.triangles[triangle];
  const dvec3 a(mesh.positions[t.x]);
  return 0.5 * glm::cross(dvec3(mesh.positions[t.y]) - a, dvec3(mesh.positions[t.z]) - a);
}

LitSides litSides(const transfer::StaticScene& scene) {
  LitSides lit;
  double sum = 0.0;
  for (std::uint32_t t = 0; t < scene.sides.size(); ++t) {
    const double area = glm::length(areaVector(*scene.mesh, t));
    if (!(area > 0.0)) continue;
    for (const bool front : {true, false}) {
      if ((scene.sides[t] & (front ? transfer::kFront : transfer::kBack)) == 0) continue;
      sum += area;
      lit.sides.push_back({t, front});
      lit.sums.push_back(sum);
    }
  }
  return lit;
}

/// Uniform by area: u chooses the side, the square root warp the point (Turk 1990).
SurfaceReceiver receiverAt(const transfer::StaticScene& scene, const LitSides& lit, Rng& rng) {
  const double place = rng.uniformDouble() * lit.sums.back();
  const auto found = std::upper_bound(lit.sums.begin(), lit.sums.end(), place);
  const auto index =
      std::min(static_cast<std::size_t>(found - lit.sums.begin()), lit.sides.size() - 1);
  const LitSides::Side& side = lit.sides[index];
  const geometry::Mesh& mesh = *scene.mesh;
  const uvec3& t = mesh.triangles[side.triangle];
  const double root = std::sqrt(rng.uniformDouble());
  const double v = rng.uniformDouble() * root;
  SurfaceReceiver receiver;
  receiver.position = (1.0 - root) * dvec3(mesh.positions[t.x]) +
                      (root - v) * dvec3(mesh.positions[t.y]) + v * dvec3(mesh.positions[t.z]);
  const dvec3 n = glm::normalize(areaVector(mesh, side.triangle));
  receiver.normal = side.front ? n : -n;
  receiver.triangle = side.triangle;
  receiver.front = side.front;
  return receiver;
}

std::uint32_t slotOf(const relight::Solver& solver, const SurfaceReceiver& r) {
  return solver.operators().texels.at(r.triangle, r.front, vec3(r.position));
}

}  // namespace

std::vector<SurfaceReceiver> drawReceivers(const relight::Solver& solver, std::size_t count,
                                           std::uint64_t seed) {
  std::vector<SurfaceReceiver> out;
  const transfer::Operators& op = solver.operators();
  if (op.texels.slotCount() == 0) return out;
  const LitSides lit = litSides(solver.scene());
  if (lit.sides.empty()) return out;
  Rng rng(mixBits(seed ^ 0x7265636569766572ULL));
  // A model of which less than a thousandth is seen is not worth more tries.
  const std::size_t most = 1000 * std::max<std::size_t>(count, 1);
  for (std::size_t i = 0; i < most && out.size() < count; ++i) {
    const SurfaceReceiver r = receiverAt(solver.scene(), lit, rng);
    const std::uint32_t slot = slotOf(solver, r);
    if (slot == transfer::kNoTexel || op.area[slot] <= 0.0F) continue;
    const transfer::StaticScene& scene = solver.scene();
    const transfer::Cover cover = transfer::coverOf(*scene.mesh, scene.sides, scene.caster, vec3(r.position),
                                                    vec3(r.normal), 0.0F);
    if (cover == transfer::Cover::matter) continue;
    out.push_back(r);
  }
  return out;
}

std::vector<SurfaceReceiver> litReceivers(
    std::span<const SurfaceReceiver> receivers, std::size_t count,
    const std::function<std::vector<bool>(std::span<const SurfaceReceiver>)>& lit_in_reference) {
  const std::vector<bool> lit = lit_in_reference(receivers);
  std::vector<SurfaceReceiver> out;
  for (std::size_t i = 0; i < receivers.size() && out.size() < count; ++i) {
    if (lit[i]) out.push_back(receivers[i]);
  }
  return out;
}

scene::Sensor toSensor(const SurfaceReceiver& receiver, const dvec3& origin) {
  return {receiver.position + origin, receiver.normal};
}

}  // namespace soffit::design

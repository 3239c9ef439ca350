// SPDX-License-Identifier: MIT
#include "core/render/emitter_hits.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

namespace soffit::render {
namespace {

using light::Emitter;
using light::EmitterKind;

/// A mesh seen through this many of its own unlit sides is taken as not there.
constexpr int kMaxLayers = 64;
constexpr int kMaxDepth = 64;

bool isVisible(const Emitter& e) {
  return e.kind != EmitterKind::point && (e.gain > 0.0 || e.casts_shadow);
}

std::unique_ptr<geometry::RayCaster> casterOf(const Emitter& e) {
  std::vector<vec3> positions(e.corners.begin(), e.corners.end());
  std::vector<uvec3> triangles(positions.size() / 3);
  for (std::uint32_t i = 0; i < triangles.size(); ++i) triangles[i] = {3 * i, 3 * i + 1, 3 * i + 2};
  return std::make_unique<geometry::RayCaster>(positions, triangles);
}

/// Slab test; a zero direction component gives infinities of the right sign. On the very plane of
/// a slab it gives NaN and the answer is arbitrary, which does no harm: boxes are padded.
bool meets(const Box& box, const vec3& origin, const vec3& inverse, float t_min, float t_max) {
  const vec3 a = (box.lo - origin) * inverse;
  const vec3 b = (box.hi - origin) * inverse;
  for (int axis = 0; axis < 3; ++axis) {
    t_min = std::max(t_min, std::min(a[axis], b[axis]));
    t_max = std::min(t_max, std::max(a[axis], b[axis]));
  }
  return t_min <= t_max;
}

/// A flat panel has a flat box; rounding must not let rays slip past it.
Box padded(Box box) {
  const float pad = 1.0e-4F + 1.0e-5F * box.diagonal();
  box.lo -= vec3(pad);
  box.hi += vec3(pad);
  return box;
}

PreciseRay precise(const geometry::Ray& ray, float t_max) {
  return {dvec3(ray.origin), dvec3(ray.direction), static_cast<double>(ray.t_min),
          static_cast<double>(t_max)};
}

}  // namespace

EmitterHits::EmitterHits(std::span<const light::Emitter> emitters)
    : emitters_(emitters), meshes_(emitters.size()) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < emitters.size(); ++i) {
    if (!isVisible(emitters[i])) continue;
    indices.push_back(static_cast<int>(i));
    has_bodies_ = has_bodies_ || emitters[i].casts_shadow;
    if (emitters[i].kind == EmitterKind::mesh) meshes_[i] = casterOf(emitters[i]);
  }
  if (!indices.empty()) build(indices);
}

void EmitterHits::build(std::span<int> indices) {
  const std::size_t node = nodes_.size();
  nodes_.emplace_back();
  Box box;
  Box centers;
  for (const int i : indices) {
    const Box& bounds = emitters_[static_cast<std::size_t>(i)].bounds;
    box.add(padded(bounds));
    centers.add(bounds.center());
  }
  nodes_[node].box = box;
  if (indices.size() == 1) {
    nodes_[node].emitter = indices.front();
    return;
  }
  const vec3 size = centers.size();
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const std::size_t half = indices.size() / 2;
  std::sort(indices.begin(), indices.end(), [&](int a, int b) {
    const float ca = emitters_[static_cast<std::size_t>(a)].bounds.center()[axis];
    const float cb = emitters_[static_cast<std::size_t>(b)].bounds.center()[axis];
    return ca != cb ? ca < cb : a < b;
  });
  build(indices.first(half));
  nodes_[node].second = static_cast<int>(nodes_.size());
  build(indices.subspan(half));
}

template <class Visit>
void EmitterHits::traverse(const geometry::Ray& ray, float& t_max, const Visit& visit) const {
  if (nodes_.empty()) return;
  const vec3 inverse = vec3(1.0F) / ray.direction;
  std::array<int, kMaxDepth> stack{};
  int top = 0;
  stack[static_cast<std::size_t>(top++)] = 0;
  while (top > 0) {
    const int index = stack[static_cast<std::size_t>(--top)];
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (!meets(node.box, ray.origin, inverse, ray.t_min, t_max)) continue;
    if (node.emitter != kNoEmitter) {
      if (visit(node.emitter)) return;
    } else {
      stack[static_cast<std::size_t>(top++)] = node.second;
      stack[static_cast<std::size_t>(top++)] = index + 1;
    }
  }
}

EmitterHit EmitterHits::test(int emitter, const PreciseRay& ray) const {
  const Emitter& e = emitters_[static_cast<std::size_t>(emitter)];
  if (e.kind == EmitterKind::mesh) return testMesh(emitter, ray);
  const auto hit = hitShape(e, ray);
  if (!hit) return {};
  return {emitter, static_cast<float>(hit->t), vec3(hit->normal), hit->emits};
}

EmitterHit EmitterHits::testMesh(int emitter, const PreciseRay& ray) const {
  const Emitter& e = emitters_[static_cast<std::size_t>(emitter)];
  geometry::Ray query{vec3(ray.origin), static_cast<float>(ray.t_min), vec3(ray.direction),
                      static_cast<float>(ray.t_max)};
  for (int layer = 0; layer < kMaxLayers; ++layer) {
    const geometry::Hit hit = meshes_[static_cast<std::size_t>(emitter)]->closest(query);
    if (!hit.valid()) return {};
    const dvec3& normal = e.triangle_normals[hit.triangle];
    const bool front = glm::dot(normal, ray.direction) < 0.0 || e.twoSided();
    if (front || e.casts_shadow) return {emitter, hit.t, vec3(normal), front && e.gain > 0.0};
    query.t_min = hit.t * (1.0F + 1.0e-6F) + 1.0e-6F;
  }
  return {};
}

EmitterHit EmitterHits::closest(const geometry::Ray& ray) const {
  EmitterHit best;
  float t_max = ray.t_max;
  traverse(ray, t_max, [&](int emitter) {
    const EmitterHit hit = test(emitter, precise(ray, t_max));
    if (hit.valid() && hit.t < t_max) {
      best = hit;
      t_max = hit.t;
    }
    return false;
  });
  return best;
}

bool EmitterHits::blocked(const geometry::Ray& ray, int except) const {
  if (!has_bodies_) return false;
  bool found = false;
  float t_max = ray.t_max;
  traverse(ray, t_max, [&](int emitter) {
    if (emitter == except || !emitters_[static_cast<std::size_t>(emitter)].casts_shadow)
      return false;
    found = test(emitter, precise(ray, t_max)).valid();
    return found;
  });
  return found;
}

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/light/emitter.h"
#include "core/render/emitter_shape_hit.h"

#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace soffit::render {

inline constexpr int kNoEmitter = -1;

/// The first luminaire that a ray meets.
struct EmitterHit {
  int emitter = kNoEmitter;  ///< index in the list that EmitterHits was made from
  float t = std::numeric_limits<float>::infinity();
  vec3 normal{0.0F};
  bool emits = false;
  [[nodiscard]] bool valid() const { return emitter != kNoEmitter; }
};

/// Finds the luminaires that rays meet: flat shapes, spheres and tubes exactly, meshes by a ray
/// caster each, under a small bounding-volume hierarchy.
///
/// Luminaires that are off and have no body are not there; neither are points. A side that gives
/// no light is seen (black) only with casts_shadow. Immutable, safe from any thread.
class EmitterHits {
 public:
  /// Refers to the emitters: they must outlive this and stay where they are.
  explicit EmitterHits(std::span<const light::Emitter> emitters);

  /// ray.direction unit.
  [[nodiscard]] EmitterHit closest(const geometry::Ray& ray) const;

  /// Whether a body (casts_shadow) other than that of `except` blocks the ray.
  [[nodiscard]] bool blocked(const geometry::Ray& ray, int except) const;

  /// Whether anything can be hit at all, and whether there are bodies.
  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] bool hasBodies() const { return has_bodies_; }

 private:
  /// A node's children are the next node and `second`; a leaf has one emitter.
  struct Node {
    Box box;
    int second = 0;
    int emitter = kNoEmitter;
  };
  void build(std::span<int> indices);
  [[nodiscard]] EmitterHit test(int emitter, const PreciseRay& ray) const;
  [[nodiscard]] EmitterHit testMesh(int emitter, const PreciseRay& ray) const;
  template <class Visit>
  void traverse(const geometry::Ray& ray, float& t_max, const Visit& visit) const;

  std::span<const light::Emitter> emitters_;
  std::vector<std::unique_ptr<geometry::RayCaster>> meshes_;  // per emitter, null unless a mesh
  std::vector<Node> nodes_;
  bool has_bodies_ = false;
};

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#pragma once

#include "core/daylight/slab.h"
#include "core/geometry/mesh.h"
#include "core/geometry/ray_caster.h"
#include "core/scene/material.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace soffit::daylight {

/// A sheet that a ray meets.
struct PaneCrossing {
  float t = 0.0F;
  std::uint32_t triangle = 0;
  double transmitted = 1.0;
  double reflected = 0.0;
};

/// The clear sheets of a scene: every triangle of a glass material is a piece of one. Everything
/// else that light meets goes to a ray caster without them (opaqueCaster()). Scene-local frame.
/// Immutable.
class Panes {
 public:
  /// Null where no triangle is glass: a scene without glass holds and asks nothing.
  static std::shared_ptr<const Panes> make(const geometry::Mesh& mesh,
                                           std::span<const scene::Material> materials);

  [[nodiscard]] bool isGlass(std::uint32_t triangle) const { return slab_of_[triangle] != kNone; }
  [[nodiscard]] const vec3& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  /// Middle and area of a glass triangle.
  [[nodiscard]] const vec3& center(std::uint32_t triangle) const { return centers_[triangle]; }
  [[nodiscard]] float area(std::uint32_t triangle) const { return areas_[triangle]; }
  /// All glass triangles, ascending.
  [[nodiscard]] std::span<const std::uint32_t> triangles() const { return triangles_; }
  [[nodiscard]] const Slab& slab(std::uint32_t triangle) const {
    return slabs_[slab_of_[triangle]];
  }

  /// The next sheet on a ray beyond t_min and before t_max; false for none. Two sheets closer than
  /// 10 micrometres (in a large model, 2^-18 of the way) along the ray count as one.
  bool next(const geometry::Ray& ray, PaneCrossing& out) const;
  /// Share of light that reaches the end of a ray's interval through all sheets on its way.
  [[nodiscard]] double transmittance(geometry::Ray ray) const;
  /// Multiplies share[i] by transmittance(rays[i]), in packets; rays whose share is 0 are left out.
  void attenuate(std::span<const geometry::Ray> rays, std::span<float> share) const;

  /// What tells two scenes' sheets apart, for a bake's key: per glass triangle its number, index
  /// and transmittance.
  [[nodiscard]] const std::vector<double>& content() const { return content_; }

  /// Where the search for the next sheet goes on after one at t.
  static float beyond(float t, const vec3& direction) {
    return t * 1.000004F + 1.0e-5F / glm::length(direction);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;
  Panes(const geometry::Mesh& mesh, std::span<const scene::Material> materials);
  [[nodiscard]] PaneCrossing crossing(const geometry::Hit& hit, const vec3& direction) const;

  std::vector<std::uint32_t> slab_of_;  ///< per triangle
  std::vector<std::uint32_t> triangles_;
  std::vector<vec3> normals_;  ///< per triangle, unit; zero for what is not glass
  std::vector<vec3> centers_;
  std::vector<float> areas_;
  std::vector<Slab> slabs_;
  std::vector<double> content_;
  geometry::RayCaster caster_;
};

/// Over all triangles that are not glass, with the mesh's own numbering. panes may be null.
geometry::RayCaster opaqueCaster(const geometry::Mesh& mesh, const Panes* panes);

}  // namespace soffit::daylight

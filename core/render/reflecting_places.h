// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/column.h"
#include "core/render/view_scene.h"
#include "core/transfer/texels.h"

#include <cstdint>
#include <utility>
#include <vector>

/// Where light is thrown from (thrown_light.h).
namespace soffit::render {

/// One side of a triangle that reflects.
struct ReflectingSide {
  std::uint32_t triangle = 0;
  bool front = true;
  double area = 0.0;    ///< m^2
  double weight = 0.0;  ///< how often it is picked
};

/// All lit sides of specular surfaces, picked by the light that arrives there times what their
/// lobes reflect; dark ones as if a tenth of the mean light fell on them.
class ReflectingPlaces {
 public:
  /// lit: lux of everything, per slot of the texels.
  ReflectingPlaces(const ViewScene& scene, const transfer::Texels& texels,
                   const relight::Planes& lit);

  [[nodiscard]] bool empty() const { return !(total_ > 0.0); }
  /// u in [0, 1), not empty(). The second is the inverse of a place's density, m^2: what a place
  /// drawn evenly on that side stands for.
  [[nodiscard]] std::pair<ReflectingSide, double> pick(double u) const;

 private:
  [[nodiscard]] static double meanLight(const ViewScene& scene, const transfer::Texels& texels,
                                        const relight::Planes& lit, const ReflectingSide& side);
  std::vector<ReflectingSide> sides_;
  std::vector<double> cumulative_;
  double total_ = 0.0;
};

/// A point of a mesh triangle: (1-u-v) a + u b + v c.
vec3 pointOf(const geometry::Mesh& mesh, std::uint32_t triangle, const vec2& barycentric);

/// Barycentric (u, v), even over a triangle, from the unit square (Osada et al. 2002).
vec2 inTriangle(const dvec2& u);

}  // namespace soffit::render

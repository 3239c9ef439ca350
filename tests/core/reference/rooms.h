// SPDX-License-Identifier: MIT
#pragma once

#include "core/reference/estimate.h"
#include "core/scene/scene.h"

#include <memory>
#include <utility>
#include <vector>

/// Small scenes for the reference's tests.
namespace soffit::reference::test {

/// Geometry under construction; every surface has its own material.
class Builder {
 public:
  /// A parallelogram corner, corner + x, corner + x + y, corner + y; front along x × y.
  Builder& quad(const dvec3& corner, const dvec3& x, const dvec3& y,
                const scene::Material& material) {
    const auto first = static_cast<std::uint32_t>(mesh_->positions.size());
    for (const dvec3& p : {corner, corner + x, corner + x + y, corner + y}) {
      mesh_->positions.emplace_back(p);
    }
    for (const vec2& uv : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1)})
      mesh_->uvs.push_back(uv);
    mesh_->triangles.emplace_back(first, first + 1, first + 2);
    mesh_->triangles.emplace_back(first, first + 2, first + 3);
    const auto index = static_cast<std::uint32_t>(scene_.materials.size());
    mesh_->material_of.insert(mesh_->material_of.end(), {index, index});
    scene_.materials.push_back(material);
    return *this;
  }

  /// The six faces of a box of one material.
  Builder& box(const dvec3& lo, const dvec3& hi, const scene::Material& material) {
    const dvec3 d = hi - lo;
    const dvec3 x(d.x, 0, 0);
    const dvec3 y(0, d.y, 0);
    const dvec3 z(0, 0, d.z);
    quad(lo, x, y, material).quad(lo + z, x, y, material);
    quad(lo, x, z, material).quad(lo + y, x, z, material);
    return quad(lo, y, z, material).quad(lo + x, y, z, material);
  }

  [[nodiscard]] scene::Scene scene() {
    scene_.mesh = mesh_;
    return scene_;
  }

 private:
  std::shared_ptr<geometry::Mesh> mesh_ = std::make_shared<geometry::Mesh>();
  scene::Scene scene_;
};

inline scene::Material matte(double albedo) {
  scene::Material m;
  m.diffuse = dvec3(albedo);
  return m;
}

inline light::Luminaire luminaire(light::Shape shape, const dvec3& position, double flux = 1000.0) {
  light::Luminaire l;
  l.name = "L";
  l.shape = std::move(shape);
  l.position = position;
  l.flux = flux;
  return l;
}

inline ReferenceScene prepare(const scene::Scene& scene,
                              const std::vector<light::Luminaire>& luminaires) {
  return ReferenceScene::make(scene, luminaires).value();
}

/// The estimate at one sensor.
inline SensorEstimate measure(const ReferenceScene& scene, const scene::Sensor& sensor,
                              const EstimateOptions& options) {
  return estimate(scene, std::vector{sensor}, options).sensors[0];
}

/// Statistical tolerances: this many standard errors; a right estimate fails one comparison in
/// 60,000 (normal), and seeds are fixed, so that a test that passes keeps passing.
inline constexpr double kSigmas = 4.3;

}  // namespace soffit::reference::test

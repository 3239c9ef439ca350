// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/emitter.h"
#include "core/light/emitter_sampling.h"
#include "core/math/sampling.h"
#include "core/render/illumination.h"
#include "core/render/view_scene.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

/// Small scenes and closed-form light for the tests of core/render.
namespace soffit::render {

/// Collects shapes into a mesh whose materials are made on the way.
class SceneBuilder {
 public:
  std::uint32_t addMaterial(const scene::Material& material) {
    scene_.materials.push_back(material);
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
  }

  /// Counter-clockwise corner, edges u and v: the front looks along u x v.
  void addQuad(const vec3& corner, const vec3& u, const vec3& v, std::uint32_t material) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    const vec3 corners[] = {corner, corner + u, corner + u + v, corner + v};
    const vec2 uvs[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 4; ++i) addVertex(corners[i], glm::normalize(glm::cross(u, v)), uvs[i]);
    addTriangle({first, first + 1, first + 2}, material);
    addTriangle({first, first + 2, first + 3}, material);
    ++object_;
  }

  /// Faces look outwards; inwards for a room.
  void addBox(const vec3& lo, const vec3& hi, std::uint32_t material, bool inwards = false) {
    const vec3 s = hi - lo;
    const vec3 x(s.x, 0, 0), y(0, s.y, 0), z(0, 0, s.z);
    const auto face = [&](const vec3& corner, const vec3& u, const vec3& v) {
      inwards ? addQuad(corner, v, u, material) : addQuad(corner, u, v, material);
    };
    face(lo, y, x);
    face(lo + z, x, y);
    face(lo, x, z);
    face(lo + y, z, x);
    face(lo, z, y);
    face(lo + x, y, z);
  }

  /// With smooth vertex normals.
  void addSphere(const vec3& center, float radius, int rows, std::uint32_t material) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    const int columns = 2 * rows;
    for (int i = 0; i <= rows; ++i) {
      for (int j = 0; j <= columns; ++j) {
        const double theta = kPi * i / rows;
        const double phi = 2 * kPi * j / columns;
        const vec3 n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                     std::cos(theta));
        addVertex(center + radius * n, n,
                  {static_cast<float>(j) / static_cast<float>(columns),
                   1.0F - static_cast<float>(i) / static_cast<float>(rows)});
      }
    }
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < columns; ++j) {
        const auto a = first + static_cast<std::uint32_t>(i * (columns + 1) + j);
        const auto b = a + static_cast<std::uint32_t>(columns + 1);
        if (i > 0) addTriangle({a, b, a + 1}, material);
        if (i < rows - 1) addTriangle({a + 1, b, b + 1}, material);
      }
    }
    ++object_;
  }

  std::unique_ptr<ViewScene> build(const std::vector<light::Luminaire>& luminaires = {}) {
    if (scene_.materials.empty()) scene_.materials.emplace_back();
    scene_.mesh = std::make_shared<geometry::Mesh>(mesh_);
    const auto panes = daylight::Panes::make(mesh_, scene_.materials);
    auto caster = std::make_shared<geometry::RayCaster>(daylight::opaqueCaster(mesh_, panes.get()));
    std::vector<light::Emitter> emitters;
    for (const auto& luminaire : luminaires) emitters.push_back(*light::makeEmitter(luminaire));
    return std::make_unique<ViewScene>(std::make_shared<scene::Scene>(scene_), std::move(caster),
                                       std::move(emitters));
  }

  void setEnvironment(const scene::Environment& environment) { scene_.environment = environment; }

 private:
  void addVertex(const vec3& p, const vec3& n, const vec2& uv) {
    mesh_.positions.push_back(p);
    mesh_.normals.push_back(n);
    mesh_.uvs.push_back(uv);
  }
  void addTriangle(const uvec3& t, std::uint32_t material) {
    mesh_.triangles.push_back(t);
    mesh_.material_of.push_back(material);
    mesh_.object_of.push_back(object_);
  }
  scene::Scene scene_;
  geometry::Mesh mesh_;
  std::uint32_t object_ = 0;
};

/// The same illuminance everywhere.
class EvenLight : public Illumination {
 public:
  explicit EvenLight(const vec3& lux) : lux_(lux) {}
  void evaluate(std::span<const SurfacePoint> points, std::span<vec3> direct,
                std::span<vec3> indirect) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      direct[i] = 0.75F * lux_;
      indirect[i] = 0.25F * lux_;
    }
  }

 private:
  vec3 lux_;
};

/// Direct light of the scene's luminaires by n shadow rays each, and an even indirect part.
/// A point source is exact: E = I cos / r^2 behind one ray.
class SampledLight : public Illumination {
 public:
  SampledLight(const ViewScene& scene, int rays, const vec3& indirect)
      : scene_(scene), rays_(rays), indirect_(indirect) {}

  void evaluate(std::span<const SurfacePoint> points, std::span<vec3> direct,
                std::span<vec3> indirect) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      indirect[i] = indirect_;
      for (const light::Emitter& e : scene_.emitters()) direct[i] += from(e, points[i]);
    }
  }

 private:
  [[nodiscard]] vec3 from(const light::Emitter& e, const SurfacePoint& point) const {
    const vec3 origin = geometry::offsetOrigin(point.position, point.normal);
    const int rays = e.kind == light::EmitterKind::point ? 1 : rays_;
    double lux = 0.0;
    for (int k = 0; k < rays; ++k) {
      const auto on = light::sampleByArea(e, r2Sequence(static_cast<std::uint32_t>(k)));
      const dvec3 d = on.point - dvec3(origin);
      const double r = glm::length(d);
      const dvec3 wi = d / r;
      const double cosine = glm::dot(wi, dvec3(point.shading_normal));
      if (cosine <= 0.0 || glm::dot(wi, dvec3(point.normal)) <= 0.0) continue;
      const double cd = e.kind == light::EmitterKind::point
                            ? e.pointIntensity(-wi)
                            : e.intensityPerArea(on.normal, -wi) / on.pdf_area;
      const geometry::Ray shadow{origin, 0.0F, vec3(wi), static_cast<float>(r - 1e-3)};
      if (cd > 0.0 && !scene_.caster().occluded(shadow)) lux += cd * cosine / (r * r) / rays;
    }
    return vec3(e.color * (e.gain * lux));
  }
  const ViewScene& scene_;
  int rays_;
  vec3 indirect_;
};

/// A white, evenly bright room about a plate of one metal; the lobe's own colour is its albedo.
inline std::unique_ptr<ViewScene> furnace(double roughness) {
  SceneBuilder builder;
  const auto white = builder.addMaterial({.diffuse = dvec3(1.0)});
  builder.addBox({-5, -5, -0.5F}, {5, 5, 5}, white, true);
  builder.addQuad(
      {-2, -2, 0}, {4, 0, 0}, {0, 4, 0},
      builder.addMaterial({.diffuse = dvec3(0.0), .specular = 0.5, .roughness = roughness}));
  return builder.build();
}

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#pragma once

#include "core/daylight/environment.h"
#include "core/daylight/panes.h"
#include "core/geometry/ray_caster.h"
#include "core/light/emitter.h"
#include "core/render/emitter_hits.h"
#include "core/render/emitter_radiance.h"
#include "core/render/mip_map.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace soffit::render {

/// A material as pictures need it.
struct ViewMaterial {
  vec3 diffuse{0.5F};
  float f0 = 0.0F;            ///< reflectance of the lobe at normal incidence; 0: none
  float alpha = 0.25F;        ///< GGX; with a map: its value where that is 1
  float least_alpha = 0.25F;  ///< anywhere on it
  float mean_alpha = 0.25F;   ///< of its mean roughness: what it reflects altogether
  std::shared_ptr<const MipMap> diffuse_map;
  std::shared_ptr<const MipMap> normal_map;
  std::shared_ptr<const MipMap> roughness_map;  ///< green: share of the roughness
  [[nodiscard]] bool hasMaps() const {
    return diffuse_map != nullptr || normal_map != nullptr || roughness_map != nullptr;
  }
};

/// A scene made ready for pictures: what rays meet, what it looks like. Immutable; everything is
/// in the scene-local frame (world minus Mesh::origin).
class ViewScene {
 public:
  /// caster    over scene->mesh without its glass (daylight::opaqueCaster()).
  /// emitters  made with origin = scene->mesh->origin; those of the layout that is shown.
  ViewScene(std::shared_ptr<const scene::Scene> scene,
            std::shared_ptr<const geometry::RayCaster> caster,
            std::vector<light::Emitter> emitters);
  ViewScene(const ViewScene&) = delete;
  ViewScene& operator=(const ViewScene&) = delete;

  [[nodiscard]] const geometry::Mesh& mesh() const { return *scene_->mesh; }
  [[nodiscard]] const std::vector<scene::Material>& materials() const { return scene_->materials; }
  [[nodiscard]] const geometry::RayCaster& caster() const { return *caster_; }
  [[nodiscard]] const std::vector<light::Emitter>& emitters() const { return emitters_; }
  [[nodiscard]] const EmitterHits& emitterHits() const { return emitter_hits_; }

  /// What a luminaire sends to an eye; see EmitterRadiance.
  [[nodiscard]] vec3 emitted(int emitter, const vec3& normal, const vec3& to_eye) const {
    const auto i = static_cast<std::size_t>(emitter);
    return emitter_radiance_[i].toward(emitters_[i], normal, to_eye);
  }

  /// The scene's glass; null without.
  [[nodiscard]] const daylight::Panes* panes() const { return panes_.get(); }
  /// What a ray sees that leaves the scene, cd/m^2; nothing without surroundings. sun: with its
  /// disc.
  [[nodiscard]] std::optional<vec3> outside(const vec3& direction, bool sun) const;

  [[nodiscard]] const ViewMaterial& material(std::uint32_t triangle) const {
    return materials_[materialIndex(triangle)];
  }
  [[nodiscard]] std::uint32_t materialIndex(std::uint32_t triangle) const {
    return mesh().material_of.empty() ? 0 : mesh().material_of[triangle];
  }
  /// Unit, counter-clockwise side; (0, 0, 1) for a triangle without area.
  [[nodiscard]] const vec3& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  /// Triangles in one plane of one object and material share a number.
  [[nodiscard]] std::uint32_t surface(std::uint32_t triangle) const { return surfaces_[triangle]; }
  /// Whether any material has a specular lobe.
  [[nodiscard]] bool hasSpecular() const { return has_specular_; }

 private:
  void makeMaterials();
  void makeSurfaces();

  std::shared_ptr<const scene::Scene> scene_;
  std::shared_ptr<const geometry::RayCaster> caster_;
  std::vector<light::Emitter> emitters_;
  EmitterHits emitter_hits_;
  std::shared_ptr<const daylight::Panes> panes_;
  std::optional<daylight::Environment> environment_;
  std::vector<EmitterRadiance> emitter_radiance_;
  std::vector<ViewMaterial> materials_;
  std::vector<vec3> normals_;
  std::vector<std::uint32_t> surfaces_;
  bool has_specular_ = false;
};

}  // namespace soffit::render

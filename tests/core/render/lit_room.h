// SPDX-License-Identifier: MIT
#pragma once

#include "core/render/view_scene.h"
#include "tests/core/relight/rooms.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

/// A room of 4 x 4 x 3 m with the engine's light and a picture's view of it.
namespace soffit::render::testing {

using relight::testing::addQuad;
using relight::testing::emptyMesh;
using relight::testing::panel;
using relight::testing::quickSettings;

inline constexpr float kWidth = 4.0F;
inline constexpr float kHeight = 3.0F;

/// Material 0: floor, 1: walls and ceiling.
inline std::shared_ptr<geometry::Mesh> roomMesh() {
  auto mesh = emptyMesh();
  mesh->materials = {"floor", "walls"};
  const float w = kWidth;
  const float h = kHeight;
  addQuad(*mesh, {0, 0, 0}, {w, 0, 0}, {w, w, 0}, {0, w, 0}, 0);
  addQuad(*mesh, {0, 0, h}, {0, w, h}, {w, w, h}, {w, 0, h}, 1);
  addQuad(*mesh, {0, 0, 0}, {0, 0, h}, {w, 0, h}, {w, 0, 0}, 1);
  addQuad(*mesh, {0, w, 0}, {w, w, 0}, {w, w, h}, {0, w, h}, 1);
  addQuad(*mesh, {0, 0, 0}, {0, w, 0}, {0, w, h}, {0, 0, h}, 1);
  addQuad(*mesh, {w, 0, 0}, {w, 0, h}, {w, w, h}, {w, w, 0}, 1);
  return mesh;
}

inline scene::Material material(double diffuse, double specular, double roughness) {
  scene::Material m;
  m.diffuse = dvec3(diffuse);
  m.specular = specular;
  m.roughness = roughness;
  return m;
}

struct LitRoom {
  scene::Scene scene;
  std::shared_ptr<relight::Lighting> lighting;
  std::unique_ptr<ViewScene> view;

  LitRoom(const scene::Material& floor, const scene::Material& walls,
          const std::vector<light::Luminaire>& lamps) {
    scene.mesh = roomMesh();
    scene.materials = {floor, walls};
    scene.luminaires = lamps;
    // Texels and lists do not know materials: one bake for all.
    static const auto statics = transfer::makeStaticScene(roomMesh(), {});
    static const auto operators = transfer::bake(*statics, quickSettings(), {}, {});
    EXPECT_TRUE(operators.ok());
    lighting = std::make_shared<relight::Lighting>(
        std::make_shared<const relight::Solver>(statics, *operators, scene.materials));
    EXPECT_TRUE(lighting->setLuminaires(lamps).ok());
    const std::shared_ptr<const geometry::RayCaster> caster(lighting,
                                                            &lighting->solver().scene().caster);
    std::vector<light::Emitter> emitters;
    for (const auto& lamp : lamps) emitters.push_back(*light::makeEmitter(lamp));
    view = std::make_unique<ViewScene>(std::make_shared<scene::Scene>(scene), caster,
                                       std::move(emitters));
  }
  [[nodiscard]] const transfer::Texels& texels() const {
    return lighting->solver().operators().texels;
  }
  /// Lumens on all texels.
  [[nodiscard]] double flux(const std::vector<float>& lux) const {
    double sum = 0.0;
    for (std::size_t s = 0; s < lux.size(); ++s) {
      sum += static_cast<double>(lux[s]) * static_cast<double>(texels().area[s]);
    }
    return sum;
  }
};

/// Small and facing down.
inline light::Luminaire spot() {
  return panel({1.2, 1.5, 2.0}, 0.02, 1000.0);
}

}  // namespace soffit::render::testing

// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/daylight/environment.h"
#include "core/daylight/panes.h"
#include "core/geometry/mesh.h"
#include "core/geometry/ray_caster.h"
#include "core/light/luminaire.h"
#include "core/reference/light_shape.h"
#include "core/reference/surroundings.h"
#include "core/scene/scene.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace soffit::reference {

/// A scene with one set of luminaires, ready for the path tracer. Immutable; cheap to copy and
/// safe to use from any thread. Everything inside is relative to the mesh's origin.
class ReferenceScene {
 public:
  /// luminaires: resolved ones of a layout (scene.luminaires are not looked at). To see some of
  /// them alone, hand over all with the others switched off: their bodies still cast shadows. Or
  /// hand over a subset: the others are not there at all.
  /// caster: over scene.mesh in its own frame without its glass (daylight::opaqueCaster()), made
  /// here when null.
  /// outside: whether the scene's environment shines.
  /// Errors: what makeEmitter() refuses.
  static Result<ReferenceScene> make(const scene::Scene& scene,
                                     std::span<const light::Luminaire> luminaires,
                                     std::shared_ptr<const geometry::RayCaster> caster = nullptr,
                                     bool outside = true);

  [[nodiscard]] const geometry::Mesh& mesh() const { return *state_->mesh; }
  [[nodiscard]] std::span<const scene::Material> materials() const { return state_->materials; }
  [[nodiscard]] const geometry::RayCaster& caster() const { return *state_->caster; }
  /// One per luminaire, in their order.
  [[nodiscard]] std::span<const LightShape> lights() const { return state_->lights; }
  /// Indices of the lights whose bodies block light, whether they shine or not.
  [[nodiscard]] std::span<const std::uint32_t> bodies() const { return state_->bodies; }

  /// The scene's glass, null without.
  [[nodiscard]] const daylight::Panes* panes() const { return state_->panes.get(); }
  /// What shines in from outside, null where nothing does.
  [[nodiscard]] const daylight::Environment* environment() const {
    return state_->environment ? &*state_->environment : nullptr;
  }
  [[nodiscard]] const SkyChoice* sky() const { return state_->sky ? &*state_->sky : nullptr; }

 private:
  struct State {
    std::shared_ptr<const geometry::Mesh> mesh;
    std::vector<scene::Material> materials;
    std::shared_ptr<const geometry::RayCaster> caster;
    std::vector<light::Emitter> emitters;  ///< lights refer to them
    std::vector<LightShape> lights;
    std::vector<std::uint32_t> bodies;
    std::shared_ptr<const daylight::Panes> panes;
    std::optional<daylight::Environment> environment;
    std::optional<SkyChoice> sky;  ///< refers to the environment
  };
  std::shared_ptr<const State> state_;
};

}  // namespace soffit::reference

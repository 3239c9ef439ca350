// SPDX-License-Identifier: MIT
#include "core/reference/reference_scene.h"

namespace soffit::reference {

Result<ReferenceScene> ReferenceScene::make(const scene::Scene& scene,
                                            std::span<const light::Luminaire> luminaires,
                                            std::shared_ptr<const geometry::RayCaster> caster,
                                            bool outside) {
  auto state = std::make_shared<State>();
  state->mesh = scene.mesh != nullptr ? scene.mesh : std::make_shared<const geometry::Mesh>();
  state->materials = scene.materials;
  state->emitters.reserve(luminaires.size());
  for (const light::Luminaire& luminaire : luminaires) {
    auto emitter = light::makeEmitter(luminaire, state->mesh->origin);
    if (!emitter) return emitter.error();
    state->emitters.push_back(std::move(*emitter));
  }
  for (const light::Emitter& emitter : state->emitters) {
    if (emitter.casts_shadow) {
      state->bodies.push_back(static_cast<std::uint32_t>(state->lights.size()));
    }
    state->lights.emplace_back(emitter);
  }
  state->panes = daylight::Panes::make(*state->mesh, state->materials);
  state->caster = caster != nullptr ? std::move(caster)
                                    : std::make_shared<const geometry::RayCaster>(
                                          daylight::opaqueCaster(*state->mesh, state->panes.get()));
  if (outside && scene.environment) {
    state->environment.emplace(*scene.environment);
    if (state->environment->dark()) {
      state->environment.reset();
    } else {
      state->sky.emplace(*state->environment, state->panes.get(), *state->mesh);
    }
  }
  ReferenceScene out;
  out.state_ = std::move(state);
  return out;
}

}  // namespace soffit::reference

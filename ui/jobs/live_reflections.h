// SPDX-License-Identifier: MIT
#pragma once

#include "core/render/live_probes.h"
#include "ui/document/scene_command.h"
#include "ui/jobs/light_frame.h"

#include <memory>
#include <vector>

namespace soffit::ui {

/// Reflections that follow the light: probes of the building in its materials, made when nothing
/// else is to do, lit with every frame. Nothing is made, kept or lit for buildings without specular
/// surfaces. Belongs to one thread.
class LiveReflections {
 public:
  /// Whether make() has something to do: another bake, other materials.
  [[nodiscard]] bool lacks(const relight::Solver& solver, const scene::Scene& scene) const;
  /// Finds what probes see, a few rays per map texel. Cancelled: what was there stays.
  void make(const std::shared_ptr<const relight::Solver>& solver, const ScenePtr& scene,
            const Job& job);
  void clear() { *this = {}; }
  /// Whether addTo() adds anything.
  [[nodiscard]] bool any() const { return probes_ != nullptr; }

  /// Adds the reflections to light of the solver that the probes were made for; after a change of
  /// materials those of the old ones, until make().
  void addTo(LightFrame& frame);

 private:
  std::shared_ptr<const relight::Solver> solver_;
  std::vector<scene::Material> materials_;
  std::shared_ptr<const render::LiveProbes> probes_;  ///< null: nothing reflects
  render::LampMaker lamps_;
};

}  // namespace soffit::ui

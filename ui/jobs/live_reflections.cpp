// SPDX-License-Identifier: MIT
#include "ui/jobs/live_reflections.h"

#include "core/glossy/lobe_shape.h"
#include "core/scene/equality.h"

#include <algorithm>
#include <chrono>

namespace soffit::ui {

bool LiveReflections::lacks(const relight::Solver& solver, const scene::Scene& scene) const {
  return solver_ == nullptr || &solver_->operators() != &solver.operators() ||
         !scene::sameReflectances(materials_, scene.materials);
}

void LiveReflections::make(const std::shared_ptr<const relight::Solver>& solver,
                           const ScenePtr& scene, const Job& job) {
  std::shared_ptr<const render::LiveProbes> probes;
  if (std::ranges::any_of(scene->materials,
                          [](const scene::Material& m) { return m.specular > 0.0; })) {
    (void)glossy::lobeTable();  // takes a second once: not in the thread that draws
    const std::shared_ptr<const geometry::RayCaster> caster(solver, &solver->scene().caster);
    const render::ViewScene view(scene, caster, {});
    probes = render::LiveProbes::make(view, solver->operators().texels, job);
    if (job.cancelled()) return;
  }
  if (solver_ == nullptr || solver_->scene().mesh != solver->scene().mesh) lamps_ = {};
  solver_ = solver;
  materials_ = scene->materials;
  probes_ = std::move(probes);
}

void LiveReflections::addTo(LightFrame& frame) {
  if (probes_ == nullptr || &solver_->operators() != &frame.solver->operators()) return;
  const auto start = std::chrono::steady_clock::now();
  frame.reflections = probes_->light(
      frame.lux, lamps_.lampsOf(frame.emitters, solver_->scene().caster, probes_->places()),
      frame.outside.get());
  frame.reflections_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace soffit::ui

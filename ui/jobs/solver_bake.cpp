// SPDX-License-Identifier: MIT
#include "ui/jobs/solver_bake.h"

#include "core/scene/equality.h"

#include <algorithm>
#include <utility>

namespace soffit::ui {

SolverBake::SolverBake(std::shared_ptr<const scene::Scene> scene, bool use_cache,
                       ProgressObserver* observer, Done done)
    : scene_(std::move(scene)),
      thread_([this, use_cache, observer, done = std::move(done)](const std::stop_token& stop) {
        run(use_cache, observer, done, stop);
      }) {}

bool SolverBake::serves(const scene::Scene& scene) const {
  // Glass is where rays go on, so it is part of the geometry; other paint is not.
  const auto glassOf = [](const scene::Material& m) {
    return m.glass ? std::pair(m.glass->index, m.glass->transmittance) : std::pair(0.0, 0.0);
  };
  return scene.mesh == scene_->mesh && scene::same(scene.quality, scene_->quality) &&
         std::ranges::equal(scene.materials, scene_->materials, {}, glassOf, glassOf);
}

void SolverBake::run(bool use_cache, ProgressObserver* observer, const Done& done,
                     const std::stop_token& stop) const {
  const auto quality = relight::qualitySettings(scene_->quality);
  if (!quality) {
    done(quality.error());
    return;
  }
  const Job job{observer, stop};
  const auto on_coarse = [&](std::shared_ptr<const relight::Solver> solver) {
    done(Outcome{std::move(solver), scene_, true, {}});
  };
  relight::EngineReport report;
  auto solver = relight::makeSolver(*scene_, *quality, use_cache, job, report, on_coarse);
  if (stop.stop_requested()) {
    done(Error{"precompute", "cancelled", ""});
    return;
  }
  if (!solver) {
    done(solver.error());
    return;
  }
  done(Outcome{*solver, scene_, false, std::move(report)});
}

}  // namespace soffit::ui

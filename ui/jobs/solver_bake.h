// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/relight/engine.h"
#include "core/scene/scene.h"

#include <functional>
#include <memory>
#include <thread>

namespace soffit::ui {

/// The precomputation of one building on a thread of its own: a coarse solver first, within
/// seconds, then the final one, or the final one at once from the cache. Deleting it cancels.
class SolverBake {
 public:
  struct Outcome {
    std::shared_ptr<const relight::Solver> solver;
    std::shared_ptr<const scene::Scene> scene;  ///< whose materials the solver has
    bool coarse = false;
    relight::EngineReport report;  ///< of the final solver
  };
  /// Called on the bake's thread: coarse and final solvers, or an error.
  using Done = std::function<void(Result<Outcome>)>;

  /// use_cache: load what an earlier bake left, and leave what this one makes.
  SolverBake(std::shared_ptr<const scene::Scene> scene, bool use_cache, ProgressObserver* observer,
             Done done);

  /// Whether a scene needs no other bake: geometry and quality are the same.
  [[nodiscard]] bool serves(const scene::Scene& scene) const;
  void cancel() { thread_.request_stop(); }

 private:
  void run(bool use_cache, ProgressObserver* observer, const Done& done,
           const std::stop_token& stop) const;

  std::shared_ptr<const scene::Scene> scene_;
  std::jthread thread_;
};

}  // namespace soffit::ui

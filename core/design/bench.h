// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/design/bench_plan.h"
#include "core/design/bench_row.h"
#include "core/design/surface_receivers.h"
#include "core/design/verify_points.h"
#include "core/relight/engine.h"
#include "core/scene/scene.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Run time against error, over methods and settings.
namespace soffit::design {

/// What every point of one project's sweep is judged by.
struct BenchCase {
  std::string scene;  ///< benchKey()
  std::string light;  ///< the luminaire that moves: the first that is on
  std::vector<SurfaceReceiver> receivers;
  ErrorSamples total;  ///< reference of all luminaires; value unused
  ErrorSamples alone;  ///< of the moved one
};

/// A key of everything that the reference of a bench depends on: geometry, materials, luminaires,
/// and how it is estimated.
std::string benchKey(const scene::Scene& scene, std::size_t receivers,
                     const ReferenceEffort& effort);

/// Draws receivers and estimates their reference. Errors: no luminaire is on; nothing is lit;
/// makeEmitter's; cancelled.
Result<BenchCase> makeBenchCase(const std::shared_ptr<const relight::Solver>& solver,
                                const scene::Scene& scene, std::size_t receivers,
                                const ReferenceEffort& effort, const Job& job);

/// As CSV, so that a sweep can be resumed: x,y,z,nx,ny,nz (scene-local),triangle,front,
/// total,total_stderr,alone,alone_stderr,light,scene.
std::string formatBenchCase(const BenchCase& bench);
/// Errors: another header, a damaged row.
Result<BenchCase> parseBenchCase(std::string_view text, const std::string& name);

/// What was baked for the points of one step.
struct BenchEngine {
  std::shared_ptr<const relight::Solver> solver;
  std::shared_ptr<const relight::Solver> coarse;  ///< nodes alone; null when there are none
  relight::EngineReport report;
};

/// Bakes afresh (the time is part of the result). Errors: the engine's.
Result<BenchEngine> makeBenchEngine(const scene::Scene& scene, const scene::Quality& quality,
                                    std::uint64_t seed, const Job& job);

/// Measures one point: the light's moves (the median over positions around its place, warmed up)
/// and the errors at its place. project, version and peak_bytes are left to the caller.
/// Errors: makeEmitter's; cancelled.
Result<BenchRow> measureBench(const BenchPoint& point, const BenchEngine& engine,
                              const scene::Scene& scene, const BenchCase& bench, const Job& job);

}  // namespace soffit::design

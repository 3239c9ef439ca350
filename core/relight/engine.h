// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/relight/lighting.h"
#include "core/relight/solver.h"
#include "core/scene/scene.h"
#include "core/transfer/operators.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soffit::relight {

/// What a quality means in numbers. Presets lie on the measured front of run time against error
/// (`soffit bench`); single settings of the project override them by these names: texels,
/// least_cell, most_cell, patch, node_rays, trainings, field_rays, list_rays, max_rank, lists,
/// tolerance, sweeps, sensor_rays.
struct QualitySettings {
  transfer::BakeSettings bake;
  int sweeps = 1;        ///< of reflected light from texel to texel (Solver::indirect())
  int sensor_rays = 64;  ///< squared: gather rays per sensor
  /// Direct light at the texels by a method of the founding papers; nothing: exactly. Setting
  /// "direct": exact, harmonics or cubes; its numbers bands, directions, reach, cube_side.
  std::optional<prt::LocalOptions> local;
};

/// A setting's name, in what range it lies, what it is at a quality, and whether it is whole.
struct SettingInfo {
  std::string name;
  double lowest = 0.0;
  double highest = 0.0;
  double value = 0.0;
  bool whole = false;
  bool of_method = false;  ///< matters with another direct method than the exact one alone
};
/// All settings that are numbers, as they are at a quality. Errors: qualitySettings()'s.
Result<std::vector<SettingInfo>> listSettings(const scene::Quality& quality);
/// Names that "direct" takes, the usual one first.
inline constexpr std::array<const char*, 3> kDirectMethods{"exact", "harmonics", "cubes"};

/// Errors: an unknown preset or setting, a value out of its range.
Result<QualitySettings> qualitySettings(const scene::Quality& quality);

/// How the engine came to be.
struct EngineReport {
  transfer::BakeCounts bake;
  bool cached = false;
  std::size_t bytes = 0;              ///< of the operators
  std::vector<std::string> messages;  ///< warnings, one line each
};

/// Called with coarse solvers, each finer than the one before, as soon as they are there.
using CoarseSolver = std::function<void(std::shared_ptr<const Solver>)>;

/// Static scene, operators (baked or from the cache) and solver of a scene.
/// Errors: quality's, cancelled.
Result<std::shared_ptr<const Solver>> makeSolver(const scene::Scene& scene,
                                                 const QualitySettings& quality, bool use_cache,
                                                 const Job& job, EngineReport& report,
                                                 const CoarseSolver& coarse = {});

/// The static half alone, for those who need no operators.
std::shared_ptr<const transfer::StaticScene> makeStaticScene(const scene::Scene& scene);

}  // namespace soffit::relight

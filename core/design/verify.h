// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/design/error_figures.h"
#include "core/design/verify_points.h"
#include "core/relight/solver.h"
#include "core/scene/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The interactive solution against the independent reference (design.md § 9, numerics.md § 2).
namespace soffit::design {

struct VerifyOptions {
  std::size_t receivers = 1000;        ///< drawn from lit surfaces
  std::vector<scene::Sensor> sensors;  ///< instead of them and of the work planes
  std::string luminaire;               ///< is reported alone too; empty: none
  std::vector<dvec3> path;             ///< its positions; empty: where it stands
  int sensor_rays = 64;                ///< squared: gather rays per sensor (QualitySettings)
  ReferenceEffort effort;
};

struct NamedFigures {
  std::string name;
  ErrorFigures figures;
};

/// Errors of one set of luminaires.
struct LightErrors {
  ErrorFigures receivers;           ///< surfaces, or the given sensors
  std::vector<NamedFigures> zones;  ///< their rooms, each against its own mean; empty for one
  std::optional<ErrorFigures> work_planes;  ///< all their points; absent without any
  std::vector<NamedFigures> planes;         ///< each against its own mean
};

/// A point with both solutions of all luminaires.
struct VerifiedPoint {
  scene::Sensor sensor;
  std::string set;   ///< "surface", "sensor", or the work plane's name
  std::string zone;  ///< its room; may be empty
  LightParts value;
  LightParts reference;
  double standard_error = 0.0;  ///< of the reference's total, lux
};

struct VerifyReport {
  LightErrors total;  ///< all luminaires of the scene, where they stand
  struct Position {
    dvec3 position;
    LightErrors alone;
    LightErrors total;  ///< with all other luminaires
  };
  struct Luminaire {
    std::string name;
    LightErrors alone;                ///< over all positions
    std::vector<Position> positions;  ///< of the path
  };
  std::optional<Luminaire> luminaire;
  std::vector<VerifiedPoint> points;  ///< surfaces, then sensors
  bool reached = true;                ///< the wanted error of the reference
  std::uint64_t rays = 0;             ///< of the reference
};

/// Compares both solutions of scene.luminaires.
///
/// A luminaire that is reported alone is estimated apart from the others and their sum is the
/// reference of the whole, so that every figure of it costs its own light only.
/// Errors: no luminaire of that name; makeEmitter's; no surface that carries light and no sensor;
/// cancelled.
Result<VerifyReport> verify(const std::shared_ptr<const relight::Solver>& solver,
                            const scene::Scene& scene, const VerifyOptions& options,
                            const Job& job = {});

}  // namespace soffit::design

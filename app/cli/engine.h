// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/common_options.h"
#include "app/cli/render_command.h"
#include "app/cli/session.h"
#include "core/relight/engine.h"
#include "core/relight/lighting.h"

#include <memory>

namespace soffit::cli {

/// The light engine as subcommands use it.
struct Engine {
  relight::QualitySettings quality;
  relight::EngineReport report;
  std::shared_ptr<const relight::Solver> solver;
  std::shared_ptr<relight::Lighting>
      lighting;  ///< of the project's luminaires; null when not asked for
};

/// Bakes or loads and, with `light`, computes all luminaires of the project's scene. The engine's
/// messages go to session.warnings.
Result<Engine> makeEngine(const io::Project& project, const CommonOptions& options, bool light,
                          const Job& job, Session& session,
                          const relight::CoarseSolver& coarse = {});

/// The seam of `soffit render`.
MakePictureLight pictureLight(Session& session);

/// The sensors of --sensors, or of all work planes in file order when `file` is empty.
/// Errors: the file's; no work planes.
Result<std::vector<scene::Sensor>> sensorsFor(const io::Project& project, const std::string& file);

/// Lux of an RGB illuminance: Rec.709 luminance.
double lux(const dvec3& rgb);

}  // namespace soffit::cli

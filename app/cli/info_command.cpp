// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/common_options.h"
#include "app/cli/info_report.h"
#include "app/cli/output.h"
#include "app/cli/progress_bar.h"
#include "core/base/parallel.h"
#include "core/relight/engine.h"
#include "core/scene/reflectances.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

namespace soffit::cli {
namespace {

/// Of the operators per display point, measured on the samples and on an imported house.
constexpr double kBytesPerReceiver = 1000.0;
/// Seconds of one core per point and ray in a gather list, likewise.
constexpr double kBakeSeconds = 4.5e-7;

/// Lit sides of a triangle: one of a solid's, two of a sheet's.
constexpr double kLitSides = 1.25;

/// From quality and area: what is already in the cache costs nothing.
Result<Cost> costOf(const scene::Scene& scene) {
  const auto quality = relight::qualitySettings(scene.quality);
  if (!quality) return quality.error();
  Cost cost;
  if (scene.mesh->triangleCount() == 0) return cost;
  // Large buildings take more points than the quality says (BakeSettings::most_cell).
  const std::vector<double> areas = scene::materialAreas(scene);
  const double cells = quality->bake.whole_cells * quality->bake.texels;
  const double square = kLitSides * std::accumulate(areas.begin(), areas.end(), 0.0) / cells;
  const double more = square / (quality->bake.most_cell * quality->bake.most_cell);
  const double points = quality->bake.texels * std::clamp(more, 1.0, 4.0);
  cost.receivers = static_cast<std::size_t>(points);
  cost.megabytes = kBytesPerReceiver * points / 1e6;
  cost.bake_s = kBakeSeconds * points * std::pow(quality->bake.list_rays, 2) / threadCount();
  return cost;
}

Result<void> runInfo(const CommonOptions& options) {
  ProgressBar progress;
  Session quiet;  // the warnings are part of the answer here
  const auto project = loadForCommand(options, quiet, &progress);
  if (!project) return project.error();
  const scene::Scene& scene = project->scene;
  const auto cost = costOf(scene);
  InfoReport report{scene::demandOf(scene),
                    cost ? *cost : Cost(),
                    {},
                    scene::materialAreas(scene),
                    project->warnings};
  // What nothing can be computed with is still worth looking at.
  if (!cost) report.warnings.push_back(cost.error().message());
  const geometry::RayCaster caster(scene.mesh->positions, scene.mesh->triangles);
  report.rooms = geometry::findSpaces(*scene.mesh, caster);
  for (std::string& line : scene::implausibleReflectances(scene)) {
    report.warnings.push_back(std::move(line));
  }
  progress.clear();
  if (!options.json) return writeResult("", toText(*project, report));
  return writeResult("", io::formatJsonLine(toJson(*project, report)) + "\n");
}

}  // namespace

void addInfoCommand(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand(
      "info", "Say what is in a project, what it will cost, what is skipped and why");
  auto options = std::make_shared<CommonOptions>();
  addProjectArgument(*command, *options);
  addLayoutOption(*command, *options);
  addSetOption(*command, *options);
  addComputeOptions(*command, *options);
  addJsonOption(*command, *options);
  command->callback([&session, options] { session.run = [options] { return runInfo(*options); }; });
}

}  // namespace soffit::cli

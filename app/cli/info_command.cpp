// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/common_options.h"
#include "app/cli/info_report.h"
#include "app/cli/output.h"
#include "app/cli/progress_bar.h"
#include "core/base/parallel.h"
#include "core/relight/engine.h"
#include "core/scene/reflectances.h"
#include "core/transfer/forecast.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <utility>

namespace soffit::cli {
namespace {

/// What is already in the cache costs nothing.
Result<Cost> costOf(const scene::Scene& scene) {
  const auto quality = relight::qualitySettings(scene.quality);
  if (!quality) return quality.error();
  Cost cost;
  if (scene.mesh->triangleCount() == 0) return cost;
  const auto building = relight::makeStaticScene(scene);
  const auto forecast = transfer::forecastBake(*building, quality->bake, threadCount());
  cost.receivers = forecast.texels;
  cost.megabytes = forecast.bytes / 1e6;
  cost.bake_s = forecast.seconds;
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

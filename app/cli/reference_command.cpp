// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/common_options.h"
#include "app/cli/engine.h"
#include "app/cli/output.h"
#include "app/cli/progress_bar.h"
#include "core/reference/estimate.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace soffit::cli {
namespace {

struct ReferenceOptions {
  CommonOptions common;
  std::string sensors;
  reference::EstimateOptions estimate;
};

const std::map<std::string, reference::Quantity>& quantities() {
  using reference::Quantity;
  static const std::map<std::string, Quantity> names{{"planar", Quantity::planar},
                                                     {"cylindrical", Quantity::cylindrical},
                                                     {"semicylindrical", Quantity::semicylindrical},
                                                     {"spherical", Quantity::spherical},
                                                     {"hemispherical", Quantity::hemispherical}};
  return names;
}

/// What is left to say when the wanted error was not reached.
std::string shortfall(const reference::Estimate& found, double floor_of_mean) {
  double mean = 0.0;
  for (const auto& s : found.sensors) mean += s.total / static_cast<double>(found.sensors.size());
  double worst = 0.0;
  for (const auto& s : found.sensors) {
    const double scale = std::max(s.total, floor_of_mean * mean);
    if (scale > 0.0) worst = std::max(worst, s.standard_error / scale);
  }
  return fmt::format(
      "stopped at the time limit after {:.1f} s: the largest relative standard error is {:.2g}. "
      "Give it more time, or a larger --error",
      found.seconds, worst);
}

std::string toCsv(const std::vector<scene::Sensor>& sensors, const reference::Estimate& found) {
  std::string text = "x,y,z,nx,ny,nz,direct,indirect,total,stderr\n";
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const dvec3& p = sensors[i].position;
    const dvec3& n = sensors[i].normal;
    const reference::SensorEstimate& s = found.sensors[i];
    text +=
        fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", p.x,
                    p.y, p.z, n.x, n.y, n.z, s.direct, s.indirect, s.total, s.standard_error);
  }
  return text;
}

Result<void> runReference(const ReferenceOptions& options, Session& session) {
  if (auto ok = checkResultFile(options.common.output); !ok) return ok;
  ProgressBar progress;
  const auto project = loadForCommand(options.common, session, &progress);
  if (!project) return project.error();
  const auto sensors = sensorsFor(*project, options.sensors);
  if (!sensors) return sensors.error();
  const auto scene = reference::ReferenceScene::make(project->scene, project->scene.luminaires);
  if (!scene) {
    Error error = scene.error();
    error.place = fmt::format("{}: {}", project->path.string(), error.place);
    return error;
  }
  reference::EstimateOptions estimate = options.estimate;
  estimate.seed = options.common.seed;
  const Job job = session.job(progress);
  const reference::Estimate found = reference::estimate(*scene, *sensors, estimate, job);
  progress.clear();
  if (job.cancelled()) return Error{"reference", "interrupted", ""};
  if (!found.reached) session.warnings.push_back(shortfall(found, estimate.floor_of_mean));
  return writeResult(options.common.output, toCsv(*sensors, found));
}

}  // namespace

void addReferenceCommand(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand(
      "reference", "Illuminance by an independent, unbiased path tracer, with standard errors");
  auto options = std::make_shared<ReferenceOptions>();
  addProjectArgument(*command, options->common);
  addLayoutOption(*command, options->common);
  addSetOption(*command, options->common);
  addComputeOptions(*command, options->common);
  addOutputOption(*command, options->common, "CSV file for the illuminances; without it: stdout");
  command
      ->add_option("--sensors", options->sensors,
                   "CSV file with points x,y,z,nx,ny,nz; without it: the work planes")
      ->type_name("FILE");
  command
      ->add_option("--error", options->estimate.relative_error,
                   "Relative standard error to reach at every sensor")
      ->check(CLI::Range(1e-6, 1.0))
      ->capture_default_str();
  command
      ->add_option("--time-limit", options->estimate.time_limit_s,
                   "Seconds after which to stop with what there is")
      ->check(positiveNumber());
  command->add_option("--quantity", options->estimate.quantity, "Which illuminance")
      ->transform(CLI::CheckedTransformer(quantities()))
      ->type_name("planar|cylindrical|semicylindrical|spherical|hemispherical");
  command->callback([&session, options] {
    session.run = [options, &session] { return runReference(*options, session); };
  });
}

}  // namespace soffit::cli

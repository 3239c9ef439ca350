// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/engine.h"
#include "app/cli/output.h"
#include "app/cli/progress_bar.h"
#include "core/io/project/csv.h"
#include "core/io/project/json.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace soffit::cli {
namespace {

struct MoveArguments {
  CommonOptions common;
  std::string luminaire;
  std::string path;
  std::string sensors;
};

struct Step {
  dvec3 position;
  relight::StageTimes times;
  std::vector<double> lux;
};

struct Stage {
  const char* name;
  double relight::StageTimes::*value;
};
constexpr std::array<Stage, 6> kStages = {{{"direct", &relight::StageTimes::direct},
                                           {"first_bounce", &relight::StageTimes::first_bounce},
                                           {"nodes", &relight::StageTimes::nodes},
                                           {"gather", &relight::StageTimes::gather},
                                           {"sweep", &relight::StageTimes::sweep},
                                           {"interpolate", &relight::StageTimes::interpolate}}};

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1,
                         static_cast<std::size_t>(q * static_cast<double>(values.size())))];
}

std::string toCsv(const std::vector<Step>& steps) {
  std::string text = "x,y,z,ms";
  for (const Stage& s : kStages) text += fmt::format(",{}_ms", s.name);
  for (std::size_t i = 0; i < steps.front().lux.size(); ++i) text += fmt::format(",E{}", i);
  text += '\n';
  for (const Step& step : steps) {
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.4f}", step.position.x, step.position.y,
                        step.position.z, step.times.total());
    for (const Stage& s : kStages) text += fmt::format(",{:.4f}", step.times.*s.value);
    for (const double e : step.lux) text += fmt::format(",{:.9g}", e);
    text += '\n';
  }
  return text;
}

Result<std::size_t> findLuminaire(const scene::Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
    if (scene.luminaires[i].name == name) return i;
  }
  std::string known;
  for (const auto& l : scene.luminaires) known += (known.empty() ? "" : ", ") + l.name;
  return Error{"--luminaire", fmt::format("the project has no luminaire \"{}\"", name),
               known.empty() ? "It has none." : "It has: " + known + "."};
}

Result<void> runMove(const MoveArguments& arguments, Session& session) {
  const CommonOptions& common = arguments.common;
  if (auto writable = checkResultFile(common.output); !writable) return writable;
  const auto path = io::readPath(arguments.path);
  if (!path) return path.error();
  std::vector<scene::Sensor> sensors;
  if (!arguments.sensors.empty()) {
    auto read = io::readSensors(arguments.sensors);
    if (!read) return read.error();
    sensors = std::move(*read);
  }
  ProgressBar progress;
  const auto project = loadForCommand(common, session, &progress);
  if (!project) return project.error();
  const auto index = findLuminaire(project->scene, arguments.luminaire);
  if (!index) return index.error();
  const auto engine = makeEngine(*project, common, true, session.job(progress), session);
  if (!engine) return engine.error();
  relight::Lighting& lighting = *engine->lighting;
  std::optional<relight::Sensors> prepared;
  if (!sensors.empty()) {
    prepared.emplace(*engine->solver, sensors, relight::Quantity::planar,
                     engine->quality.sensor_rays, common.seed);
  }
  lighting.grab(*index);
  light::Luminaire moving = project->scene.luminaires[*index];
  const auto emitterAt = [&](const dvec3& p) {
    moving.position = p;
    return light::makeEmitter(moving, project->scene.mesh->origin);
  };
  for (std::size_t k = 0; k < 5; ++k) {
    if (session.stop.stop_requested()) return Error{"move", "interrupted", ""};
    const auto emitter = emitterAt((*path)[k % path->size()]);
    if (!emitter) return emitter.error();
    lighting.move(*emitter);
  }
  light::DirectCounts counts;
  std::vector<Step> steps;
  for (std::size_t k = 0; k < path->size(); ++k) {
    if (session.stop.stop_requested()) return Error{"move", "interrupted", ""};
    const auto emitter = emitterAt((*path)[k]);
    if (!emitter) return emitter.error();
    Step step;
    step.position = (*path)[k];
    step.times = lighting.move(*emitter, &counts);
    if (prepared) {
      for (const auto& reading : lighting.read(*prepared))
        step.lux.push_back(lux(reading.direct + reading.indirect));
    }
    steps.push_back(std::move(step));
    progress.onProgress("moving", static_cast<double>(k + 1) / static_cast<double>(path->size()));
  }
  progress.clear();
  if (!common.output.empty()) {
    if (auto written = writeResult(common.output, toCsv(steps)); !written) return written;
  }
  std::vector<double> ms;
  ms.reserve(steps.size());
  for (const Step& s : steps) ms.push_back(s.times.total());
  std::vector<std::pair<std::string, double>> medians;
  for (const Stage& stage : kStages) {
    std::vector<double> values;
    values.reserve(steps.size());
    for (const Step& s : steps) values.push_back(s.times.*stage.value);
    medians.emplace_back(stage.name, quantile(values, 0.5));
  }
  const std::size_t receivers = engine->solver->operators().texels.texelCount();
  // What 64 shadow rays a point would have cost: none is traced on a move.
  const std::uint64_t avoided = counts.points * 64;
  if (common.json) {
    io::Json stages = io::Json::object({});
    for (const auto& [name, value] : medians) stages[name] = value;
    return writeResult("", io::formatJsonLine(io::Json::object({{"receivers", receivers},
                                                                {"positions", steps.size()},
                                                                {"median_ms", quantile(ms, 0.5)},
                                                                {"p99_ms", quantile(ms, 0.99)},
                                                                {"stages_ms", stages},
                                                                {"rays", 0},
                                                                {"rays_avoided", avoided}})) +
                               "\n");
  }
  if (common.output.empty()) {
    if (auto written = writeResult("", toCsv(steps)); !written) return written;
  }
  std::string text =
      fmt::format("{} receivers, {} positions: median {:.2f} ms, 99th percentile {:.2f} ms (",
                  receivers, steps.size(), quantile(ms, 0.5), quantile(ms, 0.99));
  for (std::size_t i = 0; i < medians.size(); ++i) {
    text += fmt::format("{}{} {:.2f}", i == 0 ? "" : ", ", medians[i].first, medians[i].second);
  }
  if (!common.output.empty()) return writeResult("", text + ")\n");
  return {};
}

}  // namespace

void addMoveCommand(CLI::App& app, Session& session) {
  CLI::App* command =
      app.add_subcommand("move", "Move one light along a path: milliseconds and lux per position");
  auto arguments = std::make_shared<MoveArguments>();
  addProjectArgument(*command, arguments->common);
  addLayoutOption(*command, arguments->common);
  addSetOption(*command, arguments->common);
  addComputeOptions(*command, arguments->common);
  addJsonOption(*command, arguments->common);
  addOutputOption(*command, arguments->common, "CSV file to write");
  command->add_option("--luminaire", arguments->luminaire, "Name of the luminaire that moves")
      ->required();
  command->add_option("--path", arguments->path, "Positions: CSV with x,y,z")->required();
  command->add_option("--sensors", arguments->sensors, "Sensors: CSV with x,y,z,nx,ny,nz");
  command->callback([&session, arguments] {
    session.run = [arguments, &session] { return runMove(*arguments, session); };
  });
}

}  // namespace soffit::cli

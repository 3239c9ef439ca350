// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/engine.h"
#include "app/cli/output.h"
#include "app/cli/progress_bar.h"
#include "core/io/project/json.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <memory>

namespace soffit::cli {
namespace {

Result<void> runBake(const CommonOptions& options, Session& session) {
  const auto start = std::chrono::steady_clock::now();
  ProgressBar progress;
  const auto project = loadForCommand(options, session, &progress);
  if (!project) return project.error();
  const auto engine =
      makeEngine(*project, options, false, session.job(progress), session,
                 [](const auto&) { /* asked for, so that the first result is made */ });
  if (!engine) return engine.error();
  progress.clear();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const relight::EngineReport& report = engine->report;
  const double first = report.cached ? seconds : report.bake.first_result_seconds;
  if (options.json) {
    return writeResult(
        "", io::formatJsonLine(io::Json::object(
                {{"seconds", seconds},
                 {"first_result_seconds", first},
                 {"bytes", report.bytes},
                 {"cached", report.cached},
                 {"receivers", engine->solver->operators().texels.texelCount()},
                 {"rays", report.bake.rays},
                 {"stages_s", io::Json::object({{"nodes", report.bake.node_seconds},
                                                {"training", report.bake.training_seconds},
                                                {"lists", report.bake.list_seconds}})}})) +
                "\n");
  }
  return writeResult(
      "", fmt::format("{}: {} receivers, {:.1f} MB of operators, {} in {:.1f} s{}\n",
                      project->path.filename().string(),
                      engine->solver->operators().texels.texelCount(),
                      static_cast<double>(report.bytes) / 1e6,
                      report.cached ? "read from the cache" : "baked", seconds,
                      report.cached ? "" : fmt::format(" (first result after {:.1f} s)", first)));
}

}  // namespace

void addBakeCommand(CLI::App& app, Session& session) {
  CLI::App* command =
      app.add_subcommand("bake", "Precompute; cached, so a second call returns at once");
  auto options = std::make_shared<CommonOptions>();
  addProjectArgument(*command, *options);
  addComputeOptions(*command, *options);
  addSetOption(*command, *options);
  addJsonOption(*command, *options);
  command->callback([&session, options] {
    session.run = [options, &session] { return runBake(*options, session); };
  });
}

}  // namespace soffit::cli

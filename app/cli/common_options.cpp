// SPDX-License-Identifier: MIT
#include "app/cli/common_options.h"

#include "core/base/parallel.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>

namespace soffit::cli {

namespace {

/// CLI11 takes -1 for the largest number there is.
std::string wholeNumberFault(const std::string& text) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  return digits ? std::string() : fmt::format("expected a whole number from 0, found {}", text);
}

}  // namespace

std::function<std::string(const std::string&)> positiveNumber() {
  return [](const std::string& text) {
    double value = 0.0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = code == std::errc() && end == text.data() + text.size() && value > 0.0 &&
                      std::isfinite(value);
    return good ? std::string() : fmt::format("expected a number above 0, found {}", text);
  };
}

void addSeedOption(CLI::App& command, CommonOptions& options) {
  command.add_option("--seed", options.seed, "Seed of all random numbers")
      ->check(wholeNumberFault)
      ->capture_default_str();
}

void addProjectArgument(CLI::App& command, CommonOptions& options) {
  command.add_option("P", options.project, "Project: a .soffit file, or a folder that holds one")
      ->required();
}

void addLayoutOption(CLI::App& command, CommonOptions& options) {
  command.add_option("--layout", options.layout,
                     "Layout to apply; without it: the base luminaires");
}

void addSetOption(CLI::App& command, CommonOptions& options) {
  command
      .add_option(
          "--set", options.sets,
          "KEY=VALUE: change a field after the layout, such as \"luminaires.Panel 1.flux=3000\"")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
}

void addComputeOptions(CLI::App& command, CommonOptions& options) {
  command.add_option("--threads", options.threads, "Number of threads; without it: all cores")
      ->check(CLI::Range(1, 1024));
  addSeedOption(command, options);
  command.add_option("--quality", options.quality, "Quality instead of the project's")
      ->check(CLI::IsMember({"draft", "interactive", "final"}));
  command.add_flag("--no-cache", options.no_cache, "Bake afresh instead of reading the cache");
}

void addJsonOption(CLI::App& command, CommonOptions& options) {
  command.add_flag("--json", options.json, "Print one JSON object instead of the readable table");
}

void addOutputOption(CLI::App& command, CommonOptions& options, const std::string& what) {
  command.add_option("-o,--output", options.output, what)->type_name("FILE");
}

Result<io::Project> loadForCommand(const CommonOptions& options, Session& session,
                                   ProgressObserver* observer) {
  setThreadCount(options.threads);
  io::LoadOptions load;
  load.layout = options.layout;
  if (!options.quality.empty()) load.sets.push_back("quality=" + options.quality);
  load.sets.insert(load.sets.end(), options.sets.begin(), options.sets.end());
  load.job = {observer, session.stop.get_token()};
  auto project = io::loadProject(options.project, load);
  if (project) {
    for (const std::string& warning : project->warnings) {
      session.warnings.push_back(fmt::format("{}: {}", project->path.string(), warning));
    }
  }
  return project;
}

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/session.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/project/project.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

/// Options that several subcommands share; a command adds the groups that it honours.
namespace soffit::cli {

struct CommonOptions {
  std::string project;            ///< P: a .soffit file, or a folder that holds one
  std::string layout;             ///< --layout
  std::vector<std::string> sets;  ///< --set KEY=VALUE, in order
  std::string quality;            ///< --quality; empty: the project's
  int threads = 0;                ///< --threads; 0: all cores
  std::uint64_t seed = 1;         ///< --seed
  bool no_cache = false;          ///< --no-cache: bake afresh
  bool json = false;              ///< --json: one JSON object instead of the readable table
  std::string output;             ///< -o; empty: stdout
};

/// The positional P.
void addProjectArgument(CLI::App& command, CommonOptions& options);
/// --layout.
void addLayoutOption(CLI::App& command, CommonOptions& options);
/// --set, as often as wanted.
void addSetOption(CLI::App& command, CommonOptions& options);
/// --threads, --seed, --quality, --no-cache.
void addComputeOptions(CLI::App& command, CommonOptions& options);
/// --seed alone.
void addSeedOption(CLI::App& command, CommonOptions& options);
/// --json.
void addJsonOption(CLI::App& command, CommonOptions& options);
/// -o, --output.
void addOutputOption(CLI::App& command, CommonOptions& options, const std::string& what);

/// For CLI11's check(): a finite number above 0 (CLI::PositiveNumber prints the largest double).
std::function<std::string(const std::string&)> positiveNumber();

/// Loads the project under the layout, --quality and --set (in this order) and limits the threads.
/// Its warnings go to session.warnings.
Result<io::Project> loadForCommand(const CommonOptions& options, Session& session,
                                   ProgressObserver* observer = nullptr);

}  // namespace soffit::cli

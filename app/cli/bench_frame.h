// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/common_options.h"
#include "app/cli/progress_bar.h"
#include "app/cli/session.h"
#include "core/io/project/json.h"

#include <functional>
#include <string>
#include <vector>

/// What the bench commands beside the sweep over projects have in common: -o FOLDER for tables as
/// CSV, a readable table or JSON on stdout.
namespace soffit::cli {

/// What such a command found.
struct BenchFindings {
  struct File {
    std::string name;  ///< in the folder
    std::string text;
  };
  std::string table;  ///< to read
  io::Json json;
  std::vector<File> files;  ///< written with -o alone
};

using MeasureBench = std::function<Result<BenchFindings>(ProgressBar& progress)>;

/// Makes the folder of -o, if there is one, and tries `file` in it before the long work; limits the
/// threads; measures; writes the files and prints the table or the JSON.
/// Errors: the folder's or a file's, measure()'s.
Result<void> runBenchFrame(const CommonOptions& common, const std::string& file,
                           const MeasureBench& measure);

/// Adds -o for `files` ("sh.csv", for the help), --seed and --json.
void addBenchOptions(CLI::App& command, CommonOptions& options, const std::string& files);

/// Adds --threads.
void addThreadsOption(CLI::App& command, CommonOptions& options);

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
#include "app/cli/bench_frame.h"

#include "app/cli/output.h"
#include "core/base/parallel.h"

#include <CLI/CLI.hpp>

#include <filesystem>

namespace soffit::cli {

Result<void> runBenchFrame(const CommonOptions& common, const std::string& file,
                           const MeasureBench& measure) {
  namespace fs = std::filesystem;
  const fs::path folder = common.output;
  if (!folder.empty()) {
    std::error_code trouble;  // what matters is whether the file can be written
    fs::create_directories(folder, trouble);
    if (auto ok = checkResultFile((folder / file).string()); !ok) return ok;
  }
  setThreadCount(common.threads);
  ProgressBar progress;
  const auto found = measure(progress);
  if (!found) return found.error();
  progress.clear();
  if (!folder.empty()) {
    for (const BenchFindings::File& f : found->files) {
      if (auto written = writeResult((folder / f.name).string(), f.text); !written) return written;
    }
  }
  return writeResult("", common.json ? io::formatJsonLine(found->json) + "\n" : found->table);
}

void addBenchOptions(CLI::App& command, CommonOptions& options, const std::string& files) {
  command.add_option("-o,--output", options.output, "Folder for " + files)->type_name("FOLDER");
  addSeedOption(command, options);
  addJsonOption(command, options);
}

void addThreadsOption(CLI::App& command, CommonOptions& options) {
  command.add_option("--threads", options.threads, "Number of threads; without it: all cores")
      ->check(CLI::Range(1, 1024));
}

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
#include "app/cli/bench_sh_command.h"

#include "app/cli/common_options.h"
#include "app/cli/output.h"
#include "app/cli/progress_bar.h"
#include "core/design/sh_bench.h"
#include "core/io/project/json.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace soffit::cli {
namespace {

std::string tableOf(const std::vector<design::ShBenchRow>& rows) {
  std::string text = fmt::format("{:<10} {:<28} {:>6} {:>9} {:>12} {:>10}\n", "task", "method",
                                 "bands", "samples", "ns per item", "RMS error");
  for (const design::ShBenchRow& r : rows) {
    text += fmt::format("{:<10} {:<28} {:>6} {:>9} {:>12.2f} {:>10.1e}\n", r.task, r.method,
                        r.bands, r.samples, r.ns, r.rms_error);
  }
  return text;
}

io::Json jsonOf(const std::vector<design::ShBenchRow>& rows) {
  io::JsonArray list;
  for (const design::ShBenchRow& r : rows) {
    list.push_back(io::Json::object({{"task", r.task},
                                     {"method", r.method},
                                     {"bands", r.bands},
                                     {"samples", r.samples},
                                     {"ns", r.ns},
                                     {"rms_error", r.rms_error}}));
  }
  return io::Json::object({{"rows", list}});
}

Result<void> runBenchSh(const CommonOptions& common, Session& session) {
  namespace fs = std::filesystem;
  const fs::path file = common.output.empty() ? fs::path() : fs::path(common.output) / "sh.csv";
  if (!file.empty()) {
    std::error_code trouble;
    fs::create_directories(common.output, trouble);
    if (auto ok = checkResultFile(file.string()); !ok) return ok;
  }
  ProgressBar progress;
  const auto rows = design::measureSh({.seed = common.seed}, session.job(progress));
  if (!rows) return rows.error();
  progress.clear();
  if (!file.empty()) {
    auto written = writeResult(file.string(), design::formatShBenchRows(*rows));
    if (!written) return written;
  }
  return writeResult("", common.json ? io::formatJsonLine(jsonOf(*rows)) + "\n" : tableOf(*rows));
}

}  // namespace

void addBenchShCommand(CLI::App& bench, Session& session) {
  CLI::App* command = bench.add_subcommand(
      "sh", "Spherical harmonics: time and error of each method, one thread, no project");
  auto common = std::make_shared<CommonOptions>();
  command->add_option("-o,--output", common->output, "Folder for sh.csv")->type_name("FOLDER");
  addSeedOption(*command, *common);
  addJsonOption(*command, *common);
  command->callback([&session, common] {
    session.run = [common, &session] { return runBenchSh(*common, session); };
  });
}

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
#include "app/cli/bench_sh_command.h"

#include "app/cli/bench_frame.h"
#include "core/design/sh_bench.h"
#include "core/io/project/json.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

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
  return runBenchFrame(common, "sh.csv", [&](ProgressBar& progress) -> Result<BenchFindings> {
    const auto rows = design::measureSh({.seed = common.seed}, session.job(progress));
    if (!rows) return rows.error();
    return BenchFindings{
        tableOf(*rows), jsonOf(*rows), {{"sh.csv", design::formatShBenchRows(*rows)}}};
  });
}

}  // namespace

void addBenchShCommand(CLI::App& bench, Session& session) {
  CLI::App* command = bench.add_subcommand(
      "sh", "Spherical harmonics: time and error of each method, one thread, no project");
  auto common = std::make_shared<CommonOptions>();
  addBenchOptions(*command, *common, "sh.csv");
  command->callback([&session, common] {
    session.run = [common, &session] { return runBenchSh(*common, session); };
  });
}

}  // namespace soffit::cli

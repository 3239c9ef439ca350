// SPDX-License-Identifier: MIT
#include "app/cli/bench_prt_command.h"

#include "app/cli/bench_frame.h"
#include "core/design/prt_bench.h"
#include "core/io/project/json.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace soffit::cli {
namespace {

struct BenchPrtArguments {
  CommonOptions common;
  design::PrtBenchOptions bench;
};

std::string tableOf(const std::vector<design::PrtBenchRow>& rows) {
  std::string text = fmt::format(
      "{:<8} {:<26} {:>5} {:>8} {:>9} {:>11} {:>11} {:>12} {:>9} {:>10}\n", "task", "method",
      "bands", "samples", "receivers", "ms", "CPU ms", "rays", "MB", "RMS error");
  for (const design::PrtBenchRow& r : rows) {
    text += fmt::format(
        "{:<8} {:<26} {:>5} {:>8} {:>9} {:>11.3f} {:>11.3f} {:>12} {:>9.2f} {:>10.1e}\n", r.task,
        r.method, r.bands, r.samples, r.receivers, r.ms, r.cpu_ms, r.rays, r.megabytes,
        r.rms_error);
  }
  return text;
}

io::Json jsonOf(const std::vector<design::PrtBenchRow>& rows) {
  io::JsonArray list;
  for (const design::PrtBenchRow& r : rows) {
    list.push_back(io::Json::object({{"task", r.task},
                                     {"method", r.method},
                                     {"bands", r.bands},
                                     {"samples", r.samples},
                                     {"receivers", r.receivers},
                                     {"ms", r.ms},
                                     {"cpu_ms", r.cpu_ms},
                                     {"rays", static_cast<double>(r.rays)},
                                     {"megabytes", r.megabytes},
                                     {"rms_error", r.rms_error}}));
  }
  return io::Json::object({{"rows", list}});
}

Result<void> runBenchPrt(const BenchPrtArguments& arguments, Session& session) {
  return runBenchFrame(
      arguments.common, "prt.csv", [&](ProgressBar& progress) -> Result<BenchFindings> {
        design::PrtBenchOptions options = arguments.bench;
        options.seed = arguments.common.seed;
        const auto rows = design::measurePrt(options, session.job(progress));
        if (!rows) return rows.error();
        return BenchFindings{
            tableOf(*rows), jsonOf(*rows), {{"prt.csv", design::formatPrtBenchRows(*rows)}}};
      });
}

}  // namespace

void addBenchPrtCommand(CLI::App& bench, Session& session) {
  CLI::App* command = bench.add_subcommand(
      "prt", "Diffuse transfer: time, memory and error of bakes and evaluation, no project");
  auto arguments = std::make_shared<BenchPrtArguments>();
  addBenchOptions(*command, arguments->common, "prt.csv");
  command
      ->add_option(
          "--side", arguments->bench.side,
          "Texels per side of the large transfer texture (1024: half a minute to some minutes)")
      ->check(CLI::Range(64, 4096))
      ->capture_default_str();
  command->add_option("--only", arguments->bench.only, "One task alone")
      ->check(CLI::IsMember(design::prtBenchTasks()));
  command
      ->add_option("--detail", arguments->bench.detail,
                   "0: a quick look, 1: as the figures are given")
      ->check(CLI::Range(0, 1))
      ->capture_default_str();
  addThreadsOption(*command, arguments->common);
  command->callback([&session, arguments] {
    session.run = [arguments, &session] { return runBenchPrt(*arguments, session); };
  });
}

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
#include "app/cli/bench_growth_command.h"

#include "app/cli/bench_frame.h"
#include "core/design/growth_bench.h"
#include "core/io/project/json.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace soffit::cli {
namespace {

struct BenchGrowthArguments {
  CommonOptions common;
  design::GrowthOptions bench;
};

std::string tableOf(const std::vector<design::GrowthRow>& rows) {
  std::string text = fmt::format("{:<11} {:>9} {:>10} {:>8} {:>8} {:>8} {:>8} {:>10} {:>9} {:>9}\n",
                                 "what grows", "triangles", "luminaires", "points", "bake s",
                                 "first s", "MB", "all ms", "move ms", "mix ms");
  for (const design::GrowthRow& r : rows) {
    text += fmt::format(
        "{:<11} {:>9} {:>10} {:>8} {:>8.2f} {:>8.2f} {:>8.1f} {:>10.1f} {:>9.2f} {:>9.2f}\n",
        r.task, r.triangles, r.luminaires, r.texels, r.bake_s, r.first_s, r.megabytes, r.all_ms,
        r.move_ms, r.mix_ms);
  }
  text += "\n";
  for (const design::GrowthExponent& e : design::growthExponents(rows)) {
    text += fmt::format("{:<10} ~ {}^{:.2f}\n", e.figure, e.task, e.exponent);
  }
  return text;
}

io::Json jsonOf(const std::vector<design::GrowthRow>& rows) {
  io::JsonArray list;
  for (const design::GrowthRow& r : rows) {
    list.push_back(io::Json::object({{"task", r.task},
                                     {"triangles", r.triangles},
                                     {"luminaires", r.luminaires},
                                     {"texels", r.texels},
                                     {"bake_s", r.bake_s},
                                     {"first_s", r.first_s},
                                     {"megabytes", r.megabytes},
                                     {"all_ms", r.all_ms},
                                     {"move_ms", r.move_ms},
                                     {"mix_ms", r.mix_ms}}));
  }
  io::JsonArray exponents;
  for (const design::GrowthExponent& e : design::growthExponents(rows)) {
    exponents.push_back(
        io::Json::object({{"task", e.task}, {"figure", e.figure}, {"exponent", e.exponent}}));
  }
  return io::Json::object({{"rows", list}, {"exponents", exponents}});
}

Result<void> runBenchGrowth(const BenchGrowthArguments& arguments, Session& session) {
  return runBenchFrame(
      arguments.common, "growth.csv", [&](ProgressBar& progress) -> Result<BenchFindings> {
        design::GrowthOptions options = arguments.bench;
        options.seed = arguments.common.seed;
        const auto rows = design::measureGrowth(options, session.job(progress));
        if (!rows) return rows.error();
        return BenchFindings{
            tableOf(*rows), jsonOf(*rows), {{"growth.csv", design::formatGrowthRows(*rows)}}};
      });
}

}  // namespace

void addBenchGrowthCommand(CLI::App& bench, Session& session) {
  CLI::App* command = bench.add_subcommand(
      "growth",
      "Times of bake, move and mix over triangles and luminaires of generated rooms, no project");
  auto arguments = std::make_shared<BenchGrowthArguments>();
  addBenchOptions(*command, arguments->common, "growth.csv");
  command
      ->add_option("--triangles", arguments->bench.most_triangles,
                   "The largest room: 1,000 and tenfold steps up to this")
      ->check(CLI::Range(0, 100000000))
      ->capture_default_str();
  command
      ->add_option("--luminaires", arguments->bench.most_luminaires,
                   "The most luminaires: 1 and tenfold steps up to this")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  command->add_option("--quality", arguments->bench.quality, "Of the bakes")
      ->check(CLI::IsMember({"draft", "interactive", "final"}))
      ->capture_default_str();
  addThreadsOption(*command, arguments->common);
  command->callback([&session, arguments] {
    session.run = [arguments, &session] { return runBenchGrowth(*arguments, session); };
  });
}

}  // namespace soffit::cli

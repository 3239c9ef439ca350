// SPDX-License-Identifier: MIT
#include "app/cli/bench_papers_command.h"

#include "app/cli/bench_frame.h"
#include "core/design/papers_bench.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace soffit::cli {
namespace {

struct BenchPapersArguments {
  CommonOptions common;
  design::PapersBenchOptions bench;
};

const char* const kUnknown = "not given here";

std::string orUnknown(const std::string& text) {
  return text.empty() ? kUnknown : text;
}

/// "0.5", or "0.05 - 4" where the published figure is a range.
std::string ratioText(const design::PapersRow& row) {
  if (!row.published.known()) return "";
  const std::string least = fmt::format("{:.3g}", row.leastRatio());
  const std::string most = fmt::format("{:.3g}", row.mostRatio());
  return least == most ? least : least + " - " + most;
}

std::string tableOf(const std::vector<design::PapersRow>& rows) {
  std::string text =
      fmt::format("{:<17} {:<53} {:<8} {:<14} {:<14} {:>9} {:>18} {:>8} {:>7}\n", "table", "work",
                  "unit", "published", "its machine", "ours", "ours/published", "places", "bake s");
  for (const design::PapersRow& r : rows) {
    text +=
        fmt::format("{:<17} {:<53} {:<8} {:<14} {:<14} {:>9.4g} {:>18} {:>8} {:>7.2f}\n", r.table,
                    r.work, r.unit, orUnknown(r.published.text), orUnknown(r.published.machine),
                    r.ours, ratioText(r), r.receivers, r.bake_s);
  }
  text += "ours: light through all receivers of a mesh of " +
          fmt::format("{} triangles", rows.empty() ? 0 : rows.front().triangles) +
          ", without drawing. A range: which of its scenes is ours cannot be told.\n";
  return text;
}

io::Json jsonOf(const design::PapersRow& r) {
  io::JsonObject row;
  const auto add = [&row](const char* name, io::Json value) {
    row.push_back({name, std::move(value)});
  };
  add("table", r.table);
  add("work", r.work);
  add("unit", r.unit);
  add("ours", r.ours);
  // What is not known is left out.
  if (r.published.known()) {
    add("published", r.published.text);
    add("published_low", r.published.low);
    add("published_high", r.published.high);
    add("ratio_low", r.leastRatio());
    add("ratio_high", r.mostRatio());
  }
  if (!r.published.machine.empty()) add("machine", r.published.machine);
  add("triangles", r.triangles);
  add("receivers", r.receivers);
  add("coefficients", r.coefficients);
  add("bytes", r.bytes);
  add("multiply_adds", r.multiply_adds);
  add("ms", r.ms);
  add("bake_s", r.bake_s);
  return row;
}

io::Json jsonOf(const std::vector<design::PapersRow>& rows) {
  io::JsonArray list;
  for (const design::PapersRow& r : rows) list.push_back(jsonOf(r));
  return io::Json::object({{"rows", list}});
}

Result<void> runBenchPapers(const BenchPapersArguments& arguments, Session& session) {
  return runBenchFrame(
      arguments.common, "papers.csv", [&](ProgressBar& progress) -> Result<BenchFindings> {
        design::PapersBenchOptions options = arguments.bench;
        options.seed = arguments.common.seed;
        const auto rows = design::measurePapers(options, session.job(progress));
        if (!rows) return rows.error();
        return BenchFindings{
            tableOf(*rows), jsonOf(*rows), {{"papers.csv", design::formatPapersRows(*rows)}}};
      });
}

}  // namespace

void addBenchPapersCommand(CLI::App& bench, Session& session) {
  CLI::App* command = bench.add_subcommand(
      "papers",
      "The founding papers' headline figures beside this machine's on the same work, no project");
  auto arguments = std::make_shared<BenchPapersArguments>();
  design::PapersBenchOptions& options = arguments->bench;
  addBenchOptions(*command, arguments->common, "papers.csv");
  command->add_option("--triangles", options.triangles, "Of the mesh, about")
      ->check(CLI::Range(600, 10000000))
      ->capture_default_str();
  command
      ->add_option("--side", options.side,
                   "Texels per side of the largest transfer texture; a half and a quarter as well")
      ->check(CLI::Range(64, 4096))
      ->capture_default_str();
  command
      ->add_option("--directions", options.directions,
                   "Rays per receiver of the bake; frames do not depend on them")
      ->check(CLI::Range(16, 16384))
      ->capture_default_str();
  addThreadsOption(*command, arguments->common);
  command->callback([&session, arguments] {
    session.run = [arguments, &session] { return runBenchPapers(*arguments, session); };
  });
}

}  // namespace soffit::cli

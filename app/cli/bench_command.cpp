// SPDX-License-Identifier: MIT
#include "app/cli/bench_frame.h"
#include "app/cli/bench_glossy_command.h"
#include "app/cli/bench_growth_command.h"
#include "app/cli/bench_papers_command.h"
#include "app/cli/bench_prt_command.h"
#include "app/cli/bench_report.h"
#include "app/cli/bench_sh_command.h"
#include "app/cli/bench_sweep.h"
#include "app/cli/commands.h"
#include "app/cli/layout_pictures.h"
#include "app/cli/output.h"
#include "app/cli/program_files.h"
#include "app/cli/progress_bar.h"
#include "core/io/image/file_name.h"
#include "core/io/image/write_image.h"
#include "core/io/project/json.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <set>
#include <string>

namespace soffit::cli {
namespace fs = std::filesystem;
namespace {

struct BenchArguments {
  CommonOptions common;
  std::vector<std::string> projects;
  BenchSweepOptions sweep;
};

/// The samples when no project is named.
Result<std::vector<std::string>> projectsOf(const BenchArguments& arguments) {
  if (!arguments.projects.empty()) return arguments.projects;
  std::vector<std::string> samples = sampleProjects();
  if (!samples.empty()) return samples;
  return Error{"bench", "the sample projects are not beside the program", "Name a project."};
}

Result<void> addProjects(const BenchArguments& arguments, BenchSweep& sweep, Session& session,
                         ProgressBar& progress) {
  const auto projects = projectsOf(arguments);
  if (!projects) return projects.error();
  std::set<std::string> names;
  for (const std::string& path : *projects) {
    CommonOptions common = arguments.common;
    common.project = path;
    auto project = loadForCommand(common, session, &progress);
    if (!project) return project.error();
    std::string name = io::fileNameOf(project->path.stem().string());
    while (!names.insert(name).second) name += "_";
    sweep.add(name, std::move(*project));
  }
  return {};
}

Result<std::vector<std::string>> writePlots(const fs::path& folder,
                                            const std::vector<design::BenchRow>& rows) {
  const std::vector<ChartPanel> panels = benchPanels(rows);
  const fs::path svg = folder / "bench.svg";
  const fs::path png = folder / "bench.png";
  if (const auto written = writeResult(svg.string(), chartSvg(panels)); !written) {
    return written.error();
  }
  if (const auto written = io::writeImage(png, chartImage(panels)); !written) {
    return written.error();
  }
  return std::vector<std::string>{svg.string(), png.string()};
}

Result<void> runBench(BenchArguments arguments, Session& session) {
  const auto start = std::chrono::steady_clock::now();
  fs::path& folder = arguments.sweep.folder;
  folder = arguments.common.output.empty() ? "bench" : arguments.common.output;
  arguments.sweep.effort.seed = arguments.common.seed;
  arguments.sweep.version = programVersion();
  ProgressBar progress;
  BenchSweep sweep(arguments.sweep, session.job(progress));
  if (auto added = addProjects(arguments, sweep, session, progress); !added) return added;
  std::error_code trouble;
  fs::create_directories(folder, trouble);
  if (auto ok = checkResultFile(sweep.tableFile().string()); !ok) return ok;
  if (auto resumed = sweep.resume(); !resumed) return resumed;
  if (auto done = sweep.run(); !done) return done;
  progress.clear();
  const std::vector<design::BenchRow> rows = sweep.rows();
  const auto plots = writePlots(folder, rows);
  if (!plots) return plots.error();
  std::vector<std::string> files{sweep.tableFile().string()};
  files.insert(files.end(), plots->begin(), plots->end());
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const std::vector<std::string> left_out = sweep.leftOut();
  return writeResult("", arguments.common.json
                             ? io::formatJsonLine(benchJson(rows, left_out, files, seconds)) + "\n"
                             : benchText(rows, left_out, files, seconds));
}

}  // namespace

void addBenchCommand(CLI::App& app, Session& session) {
  CLI::App* command =
      app.add_subcommand("bench", "Run time against error, over methods and settings");
  auto arguments = std::make_shared<BenchArguments>();
  arguments->sweep.effort.error = 0.01;
  command->add_option("P", arguments->projects, "Projects; without any: the samples");
  command
      ->add_option("-o,--output", arguments->common.output,
                   "Folder for bench.csv, the references and the plots; without it: bench")
      ->type_name("FOLDER");
  addLayoutOption(*command, arguments->common);
  addSetOption(*command, arguments->common);
  addThreadsOption(*command, arguments->common);
  addSeedOption(*command, arguments->common);
  addJsonOption(*command, arguments->common);
  command
      ->add_option("--budget", arguments->sweep.budget_s,
                   "Seconds; the most informative points first, a later call goes on")
      ->check(positiveNumber())
      ->capture_default_str();
  command
      ->add_option("--receivers", arguments->sweep.receivers, "Points at which errors are measured")
      ->check(CLI::Range(2, 1000000))
      ->capture_default_str();
  command
      ->add_option("--error", arguments->sweep.effort.error,
                   "Relative standard error of the reference at every point")
      ->check(CLI::Range(1e-6, 1.0))
      ->capture_default_str();
  addBenchPrtCommand(*command, session);
  addBenchShCommand(*command, session);
  addBenchGlossyCommand(*command, session);
  addBenchGrowthCommand(*command, session);
  addBenchPapersCommand(*command, session);
  command->callback([&session, arguments, command] {
    if (!command->get_subcommands().empty()) return;  // theirs was called
    session.run = [arguments, &session] { return runBench(*arguments, session); };
  });
}

}  // namespace soffit::cli

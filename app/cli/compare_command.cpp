// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/engine.h"
#include "app/cli/layout_pictures.h"
#include "app/cli/output.h"
#include "app/cli/picture_setup.h"
#include "app/cli/progress_bar.h"
#include "core/design/compare.h"
#include "core/design/compare_table.h"
#include "core/io/project/json.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

namespace soffit::cli {
namespace fs = std::filesystem;
namespace {

struct CompareArguments {
  CommonOptions common;
  std::vector<std::string> layouts;
  LayoutPictureOptions pictures;
  std::string size = "1280x800";
  bool no_pictures = false;
};

/// Names of layouts out of pieces between commas; names may hold commas themselves.
std::vector<std::string> joinedNames(const std::vector<std::string>& pieces,
                                     const std::vector<scene::Layout>& known) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < pieces.size();) {
    std::size_t end = pieces.size();
    std::string name;
    for (; end > i; --end) {
      name = pieces[i];
      for (std::size_t k = i + 1; k < end; ++k) name += "," + pieces[k];
      if (std::any_of(known.begin(), known.end(), [&](const auto& l) { return l.name == name; })) {
        break;
      }
    }
    names.push_back(end > i ? name : pieces[i]);
    i = std::max(end, i + 1);
  }
  return names;
}

/// The project under each layout that was asked for; all of them, or the base when it has none.
Result<std::vector<io::Project>> variantsOf(const io::Project& base,
                                            const CompareArguments& arguments) {
  std::vector<std::string> names = joinedNames(arguments.layouts, base.scene.layouts);
  if (names.empty()) {
    for (const scene::Layout& layout : base.scene.layouts) names.push_back(layout.name);
  }
  if (names.empty()) names.emplace_back();
  std::vector<io::Project> variants;
  for (const std::string& name : names) {
    io::LoadOptions load;
    load.layout = name;
    if (!arguments.common.quality.empty()) load.sets = {"quality=" + arguments.common.quality};
    load.sets.insert(load.sets.end(), arguments.common.sets.begin(), arguments.common.sets.end());
    auto variant = io::variantOf(base, load);
    if (!variant) return variant.error();
    variants.push_back(std::move(*variant));
  }
  return variants;
}

io::Json toJson(const std::vector<design::LayoutFigures>& layouts,
                const std::vector<std::string>& files, double seconds) {
  io::JsonArray list;
  for (const design::LayoutFigures& l : layouts) {
    io::JsonArray planes;
    for (const auto& plane : l.planes) {
      planes.push_back(io::Json::object({{"name", plane.name},
                                         {"points", plane.lux.count},
                                         {"mean_lx", plane.lux.mean},
                                         {"min_lx", plane.lux.min},
                                         {"max_lx", plane.lux.max},
                                         {"u0", plane.lux.u0}}));
    }
    list.push_back(io::Json::object({{"name", l.name},
                                     {"work_planes", planes},
                                     {"luminaires_on", l.luminaires_on},
                                     {"emitted_lm", l.emitted_lm},
                                     {"installed_lm", l.installed_lm},
                                     {"lm_per_m2", l.lm_per_m2},
                                     {"lights_computed", l.lights_computed}}));
  }
  io::JsonArray names;
  for (const std::string& file : files) names.emplace_back(file);
  return io::Json::object({{"seconds", seconds}, {"layouts", list}, {"files", names}});
}

/// The folder for results, made when missing.
Result<void> makeFolder(const std::string& folder) {
  std::error_code trouble;
  fs::create_directories(folder, trouble);
  if (trouble || !fs::is_directory(folder)) {
    return Error{folder, "the folder cannot be made", "Choose another with -o."};
  }
  return checkResultFile((fs::path(folder) / "compare.csv").string());
}

std::string nameOf(const io::Project& variant) {
  return variant.layout.empty() ? "Base" : variant.layout;
}

Result<void> runCompare(CompareArguments arguments, Session& session) {
  const auto start = std::chrono::steady_clock::now();
  const std::string& folder = arguments.common.output;
  if (!folder.empty()) {
    if (auto made = makeFolder(folder); !made) return made;
  }
  const auto size = parseSize(arguments.size);
  if (!size) return size.error();
  arguments.pictures.width = size->first;
  arguments.pictures.height = size->second;
  ProgressBar progress;
  CommonOptions base_options = arguments.common;
  base_options.sets.clear();  // they act after the layout
  const auto base = loadForCommand(base_options, session, &progress);
  if (!base) return base.error();
  const auto variants = variantsOf(*base, arguments);
  if (!variants) return variants.error();
  const io::Project& first = variants->front();
  const Job job = session.job(progress);
  const auto engine = makeEngine(first, arguments.common, false, job, session);
  if (!engine) return engine.error();
  std::vector<design::LayoutCase> layouts;
  for (const io::Project& v : *variants) layouts.push_back({nameOf(v), v.scene.luminaires});

  const bool pictures = !folder.empty() && !arguments.no_pictures;
  LayoutPictures album(folder, arguments.pictures);
  if (pictures) {
    if (auto known = album.prepare(first.scene); !known) return known;
  }
  const auto visit = [&](std::size_t i,
                         const std::shared_ptr<const relight::Lighting>& lighting) -> Result<void> {
    return album.take((*variants)[i], layouts[i].name, lighting, job);
  };
  const auto figures = design::compareLayouts(
      engine->solver, first.scene.work_planes, layouts, engine->quality.sensor_rays,
      arguments.common.seed, job, pictures ? design::LayoutVisitor(visit) : design::LayoutVisitor(),
      first.scene.environment ? std::make_shared<daylight::Environment>(*first.scene.environment)
                              : nullptr);
  if (!figures) return figures.error();
  std::vector<std::string> files = album.files();
  if (!folder.empty()) {
    files.push_back((fs::path(folder) / "compare.csv").string());
    auto written = writeResult(files.back(), design::compareCsv(*figures));
    if (!written) return written;
  }
  progress.clear();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (arguments.common.json) {
    return writeResult("", io::formatJsonLine(toJson(*figures, files, seconds)) + "\n");
  }
  std::string text = design::compareText(*figures);
  for (const std::string& file : files) text += fmt::format("wrote {}\n", file);
  return writeResult("", text);
}

}  // namespace

void addCompareCommand(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand(
      "compare", "Layouts side by side: table, pictures and difference pictures");
  auto arguments = std::make_shared<CompareArguments>();
  addProjectArgument(*command, arguments->common);
  command
      ->add_option("--layouts", arguments->layouts,
                   "Names with commas between; without it: all. The first is what others differ "
                   "from")
      ->delimiter(',');
  command
      ->add_option("-o,--output", arguments->common.output,
                   "Folder for compare.csv and the pictures; without it: the table alone")
      ->type_name("FOLDER");
  addSetOption(*command, arguments->common);
  addComputeOptions(*command, arguments->common);
  addJsonOption(*command, arguments->common);
  command->add_option("--camera", arguments->pictures.camera,
                      "Camera by name, or all; without it: the first");
  command->add_option("--size", arguments->size, "Pixels, WxH")->capture_default_str();
  command->add_option("--samples", arguments->pictures.samples, "Samples per pixel")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  command->add_option("--exposure", arguments->pictures.exposure,
                      "Stops (EV) for all pictures, or auto (by the first); without it: the "
                      "project's");
  command->add_option("--ocio-view", arguments->pictures.view,
                      "View of the pictures; without it: the project's");
  command
      ->add_option("--range", arguments->pictures.range_lux,
                   "Ends of the difference picture's scale, lux; without it: what fits")
      ->check(positiveNumber());
  command->add_flag("--no-pictures", arguments->no_pictures, "Write the table alone");
  command->callback([&session, arguments] {
    session.run = [arguments, &session] { return runCompare(*arguments, session); };
  });
}

}  // namespace soffit::cli

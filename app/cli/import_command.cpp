// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/common_options.h"
#include "app/cli/output.h"
#include "app/cli/progress_bar.h"
#include "core/io/project/import_project.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace soffit::cli {
namespace {

struct ImportOptions {
  std::string model;
  std::string up;
  double unit = 1.0;
  CommonOptions common;
};

Result<void> runImport(const ImportOptions& options, Session& session) {
  ProgressBar progress;
  io::ImportChoices choices;
  choices.unit = options.unit;
  if (!options.up.empty()) choices.up = options.up.front();
  choices.job = session.job(progress);
  const auto project = io::importProject(options.model, options.common.output, choices);
  progress.clear();
  if (!project) return project.error();
  session.warnings = project->warnings;
  const scene::Scene& scene = project->scene;
  // The size tells at a glance whether the unit and the axis were right.
  return writeResult("",
                     fmt::format("{}: {}, {} cameras, {} work planes (soffit info tells more)\n",
                                 project->path.string(), io::describeModel(io::sizeOf(scene)),
                                 scene.cameras.size(), scene.work_planes.size()));
}

}  // namespace

void addImportCommand(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand("import", "Make a project of an architectural model");
  auto options = std::make_shared<ImportOptions>();
  command
      ->add_option("MODEL", options->model, "OBJ, glTF, GLB, PLY, STL, 3DS, FBX, DAE or IFC file")
      ->required();
  command->add_option("-o,--output", options->common.output, "Project to write")
      ->required()
      ->type_name("P.soffit");
  command->add_option("--unit", options->unit, "Metres per unit of the file")
      ->check(positiveNumber())
      ->capture_default_str();
  command
      ->add_option("--up", options->up,
                   "Axis of the file that points up; without it: as the file says")
      ->check(CLI::IsMember({"y", "z"}));
  command->callback([&session, options] {
    session.run = [options, &session] { return runImport(*options, session); };
  });
}

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
#include "core/io/project/atomic_file.h"
#include "core/io/project/content.h"
#include "core/io/project/document.h"
#include "core/io/project/load_assets.h"
#include "core/io/project/overrides.h"
#include "core/io/project/project.h"
#include "core/io/project/project_folder.h"
#include "core/scene/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace soffit::io {
namespace {

constexpr double kVersion = 1.0;

Result<void> checkVersion(const Json& root, const std::string& file) {
  if (root.asObject() == nullptr) {
    return Error{file, fmt::format("expected a project, found {}", root.describe()),
                 "A project file starts with { \"soffit\": 1, ... }."};
  }
  const Json* version = root.find("soffit");
  const JsonNumber* number = version == nullptr ? nullptr : version->asNumber();
  if (number == nullptr || number->value < 1.0 || std::trunc(number->value) != number->value) {
    return Error{fmt::format("{}: soffit", file),
                 version == nullptr
                     ? "the format version is missing"
                     : fmt::format("expected the format version 1, found {}", version->describe()),
                 "A project file starts with { \"soffit\": 1, ... }."};
  }
  if (number->value > kVersion) {
    return Error{fmt::format("{}: soffit", file),
                 fmt::format("the file has format version {}, this program reads version 1",
                             version->describe()),
                 "Open it with a newer version of Soffit."};
  }
  return {};
}

/// The document with the layout and the settings applied; names of materials that only --set
/// mentions go to `set_materials`.
Result<Json> effectiveDocument(const Json& root, const LoadOptions& options, Report& report,
                               std::vector<std::string>& set_materials) {
  Json effective = root;
  if (!options.layout.empty()) {
    if (auto done = applyLayout(effective, options.layout, report.file()); !done) {
      return done.error();
    }
  }
  for (const std::string& set : options.sets) {
    auto material = applySet(effective, set, report);
    if (!material) return material.error();
    if (!material->empty()) set_materials.push_back(std::move(*material));
  }
  return effective;
}

void fillScene(ProjectContent content, const MergedGeometry& geometry, scene::Scene& scene) {
  scene.name = std::move(content.name);
  scene.mesh = geometry.mesh;
  scene.luminaires = std::move(content.luminaires);
  scene.layouts = std::move(content.layouts);
  scene.cameras = std::move(content.cameras);
  scene.work_planes = std::move(content.work_planes);
  scene.environment = std::move(content.environment);
  scene.view = std::move(content.view);
  scene.quality = std::move(content.quality);
}

std::vector<std::string> withoutRepeats(const std::vector<std::string>& lines) {
  std::vector<std::string> unique;
  std::set<std::string> seen;
  for (const std::string& line : lines) {
    if (seen.insert(line).second) unique.push_back(line);
  }
  return unique;
}

/// Everything after the document: `project` brings path, document and assets.
Result<Project> assemble(Project project, const LoadOptions& options) {
  Report report(project.path.string());
  std::vector<std::string> set_materials;
  const auto root = effectiveDocument(project.document->root, options, report, set_materials);
  if (!root) return root.error();
  ProjectContent content = readContent(*root, report);
  if (report.failed()) return report.error();
  const auto geometry = loadGeometry(content.geometry, *project.assets, options.job, report);
  if (report.failed()) return report.error();
  if (options.job.cancelled()) return Error{project.path.string(), "loading was cancelled", ""};
  for (const std::string& warning : geometry->warnings) report.warn("", warning);
  project.scene.materials =
      loadMaterials(*geometry, content.materials, set_materials, *project.assets, report);
  loadLuminaireFiles(content.luminaires, content.layouts, *project.assets, report);
  if (content.environment) loadProbe(*content.environment, *project.assets, report);
  project.geometry = content.geometry;
  project.file_materials = geometry->materials;
  fillScene(std::move(content), *geometry, project.scene);
  if (report.failed()) return report.error();
  for (Error& fault : scene::findFaults(project.scene)) {
    fault.place = fmt::format("{}: {}", report.file(), fault.place);
    return fault;
  }
  project.light_scenes = readAllLightScenes(*root);
  project.probes = probesOf(*root);
  project.layout = options.layout;
  project.overridden = !options.layout.empty() || !options.sets.empty();
  project.warnings = withoutRepeats(report.warnings());
  return project;
}

}  // namespace

Result<Project> loadProject(const std::filesystem::path& path, const LoadOptions& options) {
  const auto file = options.text ? Result<std::filesystem::path>(path) : findProjectFile(path);
  if (!file) return file.error();
  const auto text = options.text ? Result<std::string>(*options.text) : readFile(*file);
  if (!text) return text.error();
  auto root = parseJson(*text, file->string());
  if (!root) return root.error();
  if (auto version = checkVersion(*root, file->string()); !version) return version.error();
  Project project;
  project.path = *file;
  project.document = std::make_shared<const ProjectDocument>(ProjectDocument{std::move(*root)});
  project.assets = std::make_shared<AssetCache>(folderOf(*file));
  return assemble(std::move(project), options);
}

Result<Project> variantOf(const Project& project, const LoadOptions& options) {
  if (project.document == nullptr || project.assets == nullptr) {
    return Error{project.path.string(), "the project was not loaded from a file", "Save it first."};
  }
  Project variant;
  variant.path = project.path;
  variant.document = project.document;
  variant.assets = project.assets;
  return assemble(std::move(variant), options);
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/io/project/move_project.h"

#include "core/io/project/assets.h"
#include "core/io/project/companion_files.h"
#include "core/io/project/document.h"
#include "core/io/project/project_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

namespace soffit::io {
namespace fs = std::filesystem;
namespace {

bool sameFolder(const fs::path& a, const fs::path& b) {
  std::error_code code;
  return fs::equivalent(folderOf(a), folderOf(b), code) && !code;
}

/// Models that a project names, once each, as the asset cache knows them.
struct NamedModel {
  std::string file;
  double unit = 1.0;
  std::optional<char> up;
  bool operator<(const NamedModel& o) const { return file < o.file; }
};

struct NamedFiles {
  std::set<NamedModel> models;
  std::set<std::string> photometry;
  std::set<std::string> pictures;
};

void addShape(const light::Shape& shape, NamedFiles& named) {
  const auto* mesh = std::get_if<light::MeshShape>(&shape);
  if (mesh == nullptr) return;
  const auto up = mesh->up == light::kUpAsInFile ? std::nullopt : std::optional(mesh->up);
  named.models.insert({mesh->file, mesh->unit, up});
}

NamedFiles filesOf(const Project& project) {
  NamedFiles named;
  for (const GeometryEntry& entry : project.geometry) {
    named.models.insert({entry.file, entry.unit, entry.up});
  }
  for (const light::Luminaire& l : project.scene.luminaires) {
    addShape(l.shape, named);
    named.photometry.insert(l.distribution.file);
  }
  for (const scene::Layout& layout : project.scene.layouts) {
    for (const auto& [name, edit] : layout.edits) {
      if (edit.shape) addShape(*edit.shape, named);
      if (edit.distribution) named.photometry.insert(edit.distribution->file);
    }
  }
  for (const auto* materials : {&project.scene.materials, &project.file_materials}) {
    for (const scene::Material& m : *materials) {
      named.pictures.insert({m.diffuse_map, m.normal_map, m.roughness_map});
    }
  }
  if (project.scene.environment) {
    const auto* probe = std::get_if<scene::Probe>(&project.scene.environment->light);
    if (probe != nullptr) named.pictures.insert(probe->file);
  }
  return named;
}

/// The file that LM-63's TILT= line names, empty for none.
std::string tiltFileOf(const std::string& text) {
  const auto at = text.find("TILT=");
  if (at == std::string::npos) return {};
  std::string name = text.substr(at + 5, text.find_first_of("\r\n", at) - at - 5);
  while (!name.empty() && name.back() == ' ') name.pop_back();
  return name == "NONE" || name == "INCLUDE" ? std::string() : name;
}

Result<void> takeNamed(const Project& project, const NamedFiles& named, CompanionFiles& files) {
  const fs::path folder = folderOf(project.path);
  const auto takePending = [&](const std::string& name) {
    const auto pending = project.pending_files.find(name);
    if (pending == project.pending_files.end()) return false;
    files[fs::path(name).lexically_normal().generic_string()] = pending->second;
    return true;
  };
  for (const NamedModel& name : named.models) {
    if (takePending(name.file)) continue;
    const auto model = project.assets->model(name.file, name.unit, name.up);
    if (!model) return model.error();
    if (auto taken = takeModel(folder / name.file, **model, folder, files); !taken) return taken;
  }
  for (const std::string& name : named.photometry) {
    if (name.empty() || takePending(name)) continue;
    if (auto taken = takeFile(folder / name, folder, files); !taken) return taken;
    const auto text = files.find(fs::path(name).lexically_normal().generic_string());
    const std::string tilt = text == files.end() ? std::string() : tiltFileOf(text->second);
    if (tilt.empty()) continue;
    const fs::path beside = (folder / name).parent_path() / tilt;
    if (auto taken = takeFileIfThere(beside, folder, files); !taken) return taken;
  }
  for (const std::string& name : named.pictures) {
    if (name.empty()) continue;
    if (auto taken = takeFileIfThere(folder / name, folder, files); !taken) return taken;
  }
  return {};
}

/// What the scene names of the pending files, beside the project.
Result<void> writePending(const Project& project) {
  const NamedFiles named = filesOf(project);
  CompanionFiles files;
  for (const auto& pending : project.pending_files) {
    const std::string& name = pending.first;
    const bool model =
        std::ranges::any_of(named.models, [&](const NamedModel& m) { return m.file == name; });
    if (model || named.photometry.contains(name)) files.emplace(name, pending.second);
  }
  const fs::path folder = folderOf(project.path);
  if (auto fits = dropPresent(folder, files); !fits) return fits;
  return writeFiles(folder, files);
}

/// A project without a file yet has no cache of what its files hold.
std::shared_ptr<AssetCache> cacheFor(const fs::path& path, const Project& from) {
  auto cache = std::make_shared<AssetCache>(folderOf(path));
  if (from.assets != nullptr) {
    cache->merged = from.assets->merged;
    cache->merged_entries = from.assets->merged_entries;
  }
  return cache;
}

/// Where a model's files go in the project's folder: beside it, else in a folder of their own.
Result<std::string> placeFor(const fs::path& folder, const fs::path& model,
                             const CompanionFiles& files) {
  for (int number = 0; number < 1000; ++number) {
    const std::string place = number == 0
                                  ? std::string()
                                  : fmt::format("{}{}/", model.stem().string(),
                                                number == 1 ? "" : fmt::format(" {}", number));
    CompanionFiles moved;
    for (const auto& [name, content] : files) moved.emplace(place + name, content);
    if (dropPresent(folder, moved)) return place;
  }
  return Error{model.string(), "there is no free name beside the project",
               "Rename the model, or tidy the project's folder."};
}

}  // namespace

Result<Project> saveProjectAs(const Project& project, const fs::path& path) {
  Project moved = project;
  moved.path = path;
  if (sameFolder(project.path, path)) {
    if (auto written = writePending(project); !written) return written.error();
    if (auto saved = saveProject(moved, path); !saved) return saved.error();
    return moved;
  }
  CompanionFiles files;
  if (project.assets != nullptr) {
    if (auto taken = takeNamed(project, filesOf(project), files); !taken) return taken.error();
  }
  const fs::path folder = folderOf(path);
  if (auto fits = dropPresent(folder, files); !fits) return fits.error();
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  if (auto written = writeFiles(folder, files); !written) return written.error();
  if (auto saved = saveProject(moved, path); !saved) return saved.error();
  moved.assets = cacheFor(path, project);
  return moved;
}

Result<Project> withModel(const Project& project, const fs::path& model_file,
                          const ImportChoices& choices, std::vector<std::string>* written_files) {
  const fs::path folder = folderOf(project.path);
  const fs::path from = folderOf(model_file);
  const auto model = loadModel(model_file, from, choices.unit, choices.up, choices.job);
  if (!model) return model.error();
  CompanionFiles files;
  if (auto taken = takeModel(model_file, *model, from, files); !taken) return taken.error();
  const auto place = placeFor(folder, model_file, files);
  if (!place) return place.error();
  CompanionFiles moved;
  for (auto& [name, content] : files) moved.emplace(*place + name, std::move(content));
  if (auto fits = dropPresent(folder, moved); !fits) return fits.error();
  if (written_files != nullptr) {
    for (const auto& [name, content] : moved) written_files->push_back(name);
  }
  if (auto written = writeFiles(folder, moved); !written) return written.error();

  Project next = project;
  next.geometry.push_back(
      {*place + model_file.filename().generic_string(), choices.unit, choices.up});
  const auto text = formatProject(next);
  if (!text) return text.error();
  LoadOptions options;
  options.text = *text;
  options.job = choices.job;
  auto grown = loadProject(project.path, options);
  if (!grown) return grown.error();
  // The luminaires and layouts that are there stay the very same values.
  grown->scene.luminaires = project.scene.luminaires;
  grown->scene.layouts = project.scene.layouts;
  if (project.geometry.empty() && project.scene.cameras.empty()) {
    addPlaces(*grown->scene.mesh, grown->scene);
  }
  return grown;
}

}  // namespace soffit::io

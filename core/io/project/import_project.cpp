// SPDX-License-Identifier: MIT
#include "core/io/project/import_project.h"

#include "core/io/project/atomic_file.h"
#include "core/io/project/importers.h"
#include "core/io/project/project_folder.h"
#include "core/io/project/room_places.h"
#include "core/io/project/starting_place.h"
#include "core/scene/reflectances.h"

#include <fmt/format.h>

#include <charconv>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace soffit::io {
namespace fs = std::filesystem;
namespace {

/// Files to write beside the project: relative path and content. Nothing is written before all
/// are known to fit.
using Files = std::map<std::string, std::string>;

/// Takes a file of the model's folder over at the same relative place.
Result<void> takeFile(const fs::path& file, const fs::path& from_folder, Files& files) {
  std::error_code code;
  const fs::path relative = fs::relative(file, from_folder, code);
  if (code || relative.empty() || *relative.begin() == "..") return {};  // the reader refused it
  auto content = readFile(file, std::size_t{4} << 30U);
  if (!content) return content.error();
  files.emplace(relative.generic_string(), std::move(*content));
  return {};
}

/// The textures that are files: those that exist beside the model.
std::set<std::string> textureFiles(const LoadedModel& model, const fs::path& folder) {
  std::set<std::string> names;
  for (const scene::Material& material : model.materials) {
    for (const std::string& map : {material.diffuse_map, material.normal_map}) {
      std::error_code ignored;
      if (!map.empty() && fs::is_regular_file(folder / map, ignored)) names.insert(map);
    }
  }
  return names;
}

Result<Files> filesOf(const fs::path& model_file, const LoadedModel& model) {
  const fs::path folder = folderOf(model_file);
  Files files;
  if (auto taken = takeFile(model_file, folder, files); !taken) return taken.error();
  for (const fs::path& side : model.side_files) {
    if (auto taken = takeFile(side, folder, files); !taken) return taken.error();
  }
  for (const std::string& texture : textureFiles(model, folder)) {
    if (auto taken = takeFile(folder / texture, folder, files); !taken) return taken.error();
  }
  for (const auto& [name, bytes] : model.embedded) files.emplace(name, bytes);
  return files;
}

/// Drops what is there already with the same content; an error for other content.
Result<void> dropPresent(const fs::path& folder, Files& files) {
  for (auto entry = files.begin(); entry != files.end();) {
    const fs::path target = folder / entry->first;
    std::error_code ignored;
    if (!fs::exists(target, ignored)) {
      ++entry;
      continue;
    }
    const auto present = readFile(target, std::size_t{4} << 30U);
    if (!present) return present.error();
    if (*present != entry->second) {
      return Error{target.string(), "another file of this name is there already",
                   "Choose another folder for the project, or remove that file."};
    }
    entry = files.erase(entry);
  }
  return {};
}

Result<void> writeFiles(const fs::path& folder, const Files& files) {
  for (const auto& [name, content] : files) {
    const fs::path target = folder / name;
    std::error_code code;
    fs::create_directories(target.parent_path(), code);
    if (code) {
      return Error{target.parent_path().string(), "the folder cannot be made: " + code.message(),
                   "Choose another place."};
    }
    if (auto written = writeFileAtomically(target, content); !written) return written;
  }
  return {};
}

/// Model files give single precision: 0.7 arrives as 0.699999988. The shortest decimal that means
/// the same float is what its author wrote.
double shortDecimal(double value) {
  const auto single = static_cast<float>(value);
  if (static_cast<double>(single) != value) return value;
  char digits[32];
  const auto end = std::to_chars(std::begin(digits), std::end(digits), single);
  double decimal = value;
  std::from_chars(std::begin(digits), end.ptr, decimal);
  return decimal;
}

/// The materials as the project states them. Of one that the model does not describe the project
/// says nothing either, so that it is warned about until somebody decides.
void takeMaterials(const LoadedModel& model, Project& project) {
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    scene::Material material = model.materials[i];
    if (!model.described[i] && !material.glass) {
      project.file_materials.push_back(material);
      project.warnings.push_back(fmt::format(
          "materials.{}: the model tells no colour; diffuse 0.5 is taken", material.name));
    }
    for (int k = 0; k < 3; ++k) material.diffuse[k] = shortDecimal(material.diffuse[k]);
    material.specular = shortDecimal(material.specular);
    material.roughness = shortDecimal(material.roughness);
    project.scene.materials.push_back(std::move(material));
  }
}

/// Somewhere to stand and to measure: in every room of a building, else where it is widest.
void takePlaces(const geometry::Mesh& mesh, scene::Scene& scene) {
  StartingPlace start = startingPlace(mesh);
  scene.cameras.push_back(std::move(start.camera));
  const geometry::RayCaster caster(mesh.positions, mesh.triangles);
  const auto spaces = geometry::findSpaces(mesh, caster);
  if (spaces.size() < 2) {
    if (start.work_plane) scene.work_planes.push_back(*start.work_plane);
    return;
  }
  RoomPlaces places = roomPlaces(spaces, roomNames(spaces.size()), mesh.origin);
  scene.cameras.insert(scene.cameras.end(), places.cameras.begin(), places.cameras.end());
  scene.work_planes = std::move(places.work_planes);
}

Project makeProject(const fs::path& file, const fs::path& model_file, const LoadedModel& model,
                    const ImportChoices& choices) {
  Project project;
  project.path = file;
  project.geometry.push_back({model_file.filename().string(), choices.unit, choices.up});
  project.scene.name = file.stem().string();
  project.scene.mesh = model.mesh;
  takeMaterials(model, project);
  project.scene.layouts.push_back({"Base", {}});
  takePlaces(*model.mesh, project.scene);
  project.warnings.insert(project.warnings.end(), model.warnings.begin(), model.warnings.end());
  for (std::string& line : scene::implausibleReflectances(project.scene)) {
    project.warnings.push_back(std::move(line));
  }
  return project;
}

}  // namespace

Result<Project> importProject(const fs::path& model_file, const fs::path& file,
                              const ImportChoices& choices) {
  if (file.extension() != ".soffit") {
    return Error{file.string(), "a project's name ends in .soffit", "Name it NAME.soffit."};
  }
  const auto model =
      loadModel(model_file, folderOf(model_file), choices.unit, choices.up, choices.job);
  if (!model) return model.error();
  Project project = makeProject(file, model_file, *model, choices);
  const auto text = formatProject(project);
  if (!text) return text.error();
  auto files = filesOf(model_file, *model);
  if (!files) return files.error();
  const fs::path folder = folderOf(file);
  if (auto fits = dropPresent(folder, *files); !fits) return fits.error();
  std::error_code code;
  fs::create_directories(folder, code);
  if (auto written = writeFiles(folder, *files); !written) return written.error();
  if (auto written = writeFileAtomically(file, *text, Previous::kept_as_backup); !written) {
    return written.error();
  }
  return project;
}

}  // namespace soffit::io

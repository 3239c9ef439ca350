// SPDX-License-Identifier: MIT
#include "core/io/project/import_project.h"

#include "core/io/model/model_format.h"
#include "core/io/project/atomic_file.h"
#include "core/io/project/companion_files.h"
#include "core/io/project/importers.h"
#include "core/io/project/project_folder.h"
#include "core/io/project/room_places.h"
#include "core/io/project/starting_place.h"
#include "core/scene/reflectances.h"

#include <fmt/format.h>

#include <charconv>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

namespace soffit::io {
namespace fs = std::filesystem;
namespace {

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

Project makeProject(const fs::path& file, const fs::path& model_file, const LoadedModel& model,
                    const ImportChoices& choices) {
  Project project;
  project.path = file;
  project.geometry.push_back({model_file.filename().string(), choices.unit, choices.up});
  project.scene.name = file.stem().string();
  project.scene.mesh = model.mesh;
  takeMaterials(model, project);
  project.scene.layouts.push_back({"Layout 1", {}});
  addPlaces(*model.mesh, project.scene);
  project.warnings.insert(project.warnings.end(), model.warnings.begin(), model.warnings.end());
  for (std::string& line : scene::implausibleReflectances(project.scene)) {
    project.warnings.push_back(std::move(line));
  }
  return project;
}

}  // namespace

Result<ModelSize> measureModel(const fs::path& model_file, const ImportChoices& choices) {
  const auto model =
      loadModel(model_file, folderOf(model_file), choices.unit, choices.up, choices.job);
  if (!model) return model.error();
  return ModelSize{dvec3(model->mesh->bounds().size()), model->mesh->triangleCount(),
                   model->materials.size()};
}

void addPlaces(const geometry::Mesh& mesh, scene::Scene& scene) {
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

ModelSize sizeOf(const scene::Scene& scene) {
  return {dvec3(scene.mesh->bounds().size()), scene.mesh->triangleCount(), scene.materials.size()};
}

std::string describeModel(const ModelSize& size) {
  return fmt::format("{} triangles, {} materials, {:.2f} x {:.2f} m in plan, {:.2f} m high",
                     size.triangles, size.materials, size.size_m.x, size.size_m.y, size.size_m.z);
}

bool isModelFile(const fs::path& file) {
  return modelFormat(file).has_value();
}

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
  CompanionFiles files;
  if (auto taken = takeModel(model_file, *model, folderOf(model_file), files); !taken) {
    return taken.error();
  }
  const fs::path folder = folderOf(file);
  if (auto fits = dropPresent(folder, files); !fits) return fits.error();
  std::error_code code;
  fs::create_directories(folder, code);
  if (auto written = writeFiles(folder, files); !written) return written.error();
  if (auto written = writeFileAtomically(file, *text, Previous::kept_as_backup); !written) {
    return written.error();
  }
  return project;
}

}  // namespace soffit::io

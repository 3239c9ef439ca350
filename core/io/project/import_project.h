// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/project/project.h"

#include <filesystem>
#include <optional>
#include <string>

namespace soffit::io {

struct ImportChoices {
  double unit = 1.0;       ///< metres per unit of the file, above 0
  std::optional<char> up;  ///< 'y' or 'z'; absent: what the file or its format says
  Job job;
};

/// How large a model is, to see at a glance whether unit and axis are right.
struct ModelSize {
  dvec3 size_m{0.0};  ///< along x, y and z (up), metres
  std::size_t triangles = 0;
  std::size_t materials = 0;
};

/// Reads a model for its size. Errors: unreadable, cancelled.
Result<ModelSize> measureModel(const std::filesystem::path& model, const ImportChoices& choices);

/// The same of an imported project, in a line: "12 triangles, 1 materials, 6.00 x 4.00 m in plan,
/// 3.00 m high".
std::string describeModel(const ModelSize& size);
ModelSize sizeOf(const scene::Scene& scene);

/// Gives a scene somewhere to stand and to measure: a camera and a work plane in every room of a
/// building, else where it is widest.
void addPlaces(const geometry::Mesh& mesh, scene::Scene& scene);

/// Whether importProject() knows the file's extension.
bool isModelFile(const std::filesystem::path& file);

/// Makes a project of an architectural model and writes it to `project` (NAME.soffit; its folder
/// is made if need be).
///
/// The model, the files that it names (MTL, BIN) and its textures are copied beside the project,
/// at the same relative places; textures stored inside the model are written out. The project has
/// the geometry, the materials that were found, a camera and a work plane in the largest space at
/// eye height (startingPlace()), the layout "Layout 1" and no luminaires.
///
/// Errors: an unreadable model; a file of the same name but other content beside the project, or
/// anything that cannot be written. An existing project is kept as NAME.soffit~.
Result<Project> importProject(const std::filesystem::path& model,
                              const std::filesystem::path& project, const ImportChoices& choices);

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/mesh.h"
#include "core/photometry/intensity_distribution.h"
#include "core/scene/material.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The one place where the project meets the readers of models, photometry and pictures
/// (internal to io_project).
namespace soffit::io {

/// A model file as the project needs it. Names are UTF-8.
struct LoadedModel {
  std::shared_ptr<const geometry::Mesh> mesh;  ///< metres, z up; has at least one triangle
  std::vector<scene::Material>
      materials;                ///< index = Mesh::materials; maps relative to the model, not loaded
  std::vector<bool> described;  ///< whether the file tells the material's colour
  std::vector<std::string> warnings;
  std::vector<std::filesystem::path> side_files;  ///< opened besides the model: MTL, BIN
  /// Pictures inside the model: where a material expects them, relative to the model, and bytes.
  std::vector<std::pair<std::string, std::string>> embedded;
};

/// folder: what side files and textures may not leave.
/// unit: metres per unit of the file; up: 'y', 'z', or what the file says.
/// Errors: unreadable, no triangle left, cancelled.
Result<LoadedModel> loadModel(const std::filesystem::path& path,
                              const std::filesystem::path& folder, double unit,
                              std::optional<char> up, const Job& job);

struct LoadedPhotometry {
  std::shared_ptr<const photometry::IntensityDistribution> table;
  std::vector<std::string> warnings;
};

/// Errors: unreadable, or a kind of file other than the key that names it.
Result<LoadedPhotometry> loadPhotometry(const std::filesystem::path& path);

enum class ImageUse { color, data };

/// color: decoded from sRGB to linear; data (normals, roughness): as stored, 0..1. Three channels.
Result<std::shared_ptr<const scene::Image>> loadImage(const std::filesystem::path& path,
                                                      ImageUse use);

}  // namespace soffit::io

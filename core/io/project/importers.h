// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/geometry/mesh.h"
#include "core/photometry/intensity_distribution.h"
#include "core/scene/material.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// The one place where the project meets the readers of models, photometry and pictures
/// (internal to io_project).
namespace soffit::io {

/// A model file as the project needs it.
struct LoadedModel {
  std::shared_ptr<const geometry::Mesh> mesh;  ///< metres, z up; has at least one triangle
  std::vector<scene::Material> materials;      ///< index = Mesh::materials
  std::vector<bool> described;                 ///< whether the file tells the material's colour
  std::vector<std::string> warnings;
};

/// unit: metres per unit of the file; up: 'y' or 'z'.
/// Errors: unreadable, no triangle left.
Result<LoadedModel> loadModel(const std::filesystem::path& path, double unit, char up);

struct LoadedPhotometry {
  std::shared_ptr<const photometry::IntensityDistribution> table;
  std::vector<std::string> warnings;
};

/// Errors: unreadable, or a kind of file other than the key that names it.
Result<LoadedPhotometry> loadPhotometry(const std::filesystem::path& path);

enum class ImageUse { color, normal };

/// color: decoded from sRGB to linear; normal: as stored, 0..1. Three channels.
Result<std::shared_ptr<const scene::Image>> loadImage(const std::filesystem::path& path,
                                                      ImageUse use);

}  // namespace soffit::io

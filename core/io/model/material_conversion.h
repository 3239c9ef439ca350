// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/io/model/model_format.h"
#include "core/io/model/model_import.h"

struct aiMaterial;
struct aiScene;

namespace soffit::io {

/// What the materials of one file are judged by.
struct MaterialContext {
  const aiScene& scene;
  ModelFormat format;
  std::filesystem::path file;        ///< the model
  std::filesystem::path folder;      ///< textures may not lie outside
  std::set<std::string> mtl_colors;  ///< OBJ: names that state a Kd
};

struct ConvertedMaterial {
  scene::Material material;
  bool described = false;  ///< the file states a color
  std::vector<std::string> warnings;
};

/// Reads one material by the rules of core/io/model/README.md. Textures stored in the file are
/// added to `embedded`, each once.
ConvertedMaterial convertMaterial(const aiMaterial& source, const MaterialContext& context,
                                  std::vector<EmbeddedTexture>& embedded);

}  // namespace soffit::io

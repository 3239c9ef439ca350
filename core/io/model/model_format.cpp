// SPDX-License-Identifier: MIT
#include "core/io/model/model_format.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace soffit::io {

std::optional<ModelFormat> modelFormat(const std::filesystem::path& file) {
  constexpr std::array<std::pair<std::string_view, ModelFormat>, 9> kExtensions{
      {{".obj", ModelFormat::kObj},
       {".gltf", ModelFormat::kGltf},
       {".glb", ModelFormat::kGltf},
       {".ply", ModelFormat::kPly},
       {".stl", ModelFormat::kStl},
       {".3ds", ModelFormat::k3ds},
       {".fbx", ModelFormat::kFbx},
       {".dae", ModelFormat::kCollada},
       {".ifc", ModelFormat::kIfc}}};
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  for (const auto& [name, format] : kExtensions) {
    if (extension == name) return format;
  }
  return std::nullopt;
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

namespace soffit::io {

enum class ModelFormat { kObj, kGltf, kPly, kStl, k3ds, kFbx, kCollada, kIfc };

/// The format by the file name's extension, in any case of letters; absent if it is none of ours.
std::optional<ModelFormat> modelFormat(const std::filesystem::path& file);

}  // namespace soffit::io

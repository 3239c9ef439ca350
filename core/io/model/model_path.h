// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Paths that model files give to their textures and side files.
namespace soffit::io {

/// Whether a path lies in a folder or below it, links and ".." resolved.
bool liesInFolder(const std::filesystem::path& path, const std::filesystem::path& folder);

/// A texture as named in a model file, found on disk.
struct TexturePath {
  std::string relative;  ///< to the model's folder, with '/'; empty if it cannot be used
  std::string problem;   ///< why not, one line; or empty
};

/// Finds the texture `name` (relative to the model's folder, '/' or '\' between folders, %20 and
/// the like decoded if needed). A path that leads nowhere or outside of `folder`, as exporters
/// write with drive letters, is looked up beside the model by its file name alone.
TexturePath findTexture(std::string_view name, const std::filesystem::path& model,
                        const std::filesystem::path& folder);

}  // namespace soffit::io

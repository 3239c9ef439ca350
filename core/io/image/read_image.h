// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/scene/material.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Reading pictures (PNG, JPEG, TIFF, Radiance HDR, OpenEXR and what else OpenImageIO knows).
namespace soffit::io {

/// Key and value, in the order of the file.
using Metadata = std::vector<std::pair<std::string, std::string>>;

struct ReadOptions {
  /// Integer files hold sRGB code values: give linear ones. Float files are linear as they stand.
  bool decode_srgb = true;
  /// Larger pictures are refused before memory is taken for them.
  std::size_t max_pixels = std::size_t{1} << 27U;
};

/// Three channels (grey is repeated, alpha dropped), row 0 at the top. Integer files give 0..1.
/// What is not a number in the file becomes 0.
/// Errors: no such file, unknown or broken format, empty picture, more than max_pixels.
Result<scene::Image> readImage(const std::filesystem::path& path, const ReadOptions& options = {});

/// What writeImage() stored: "Software" and the keys of the description.
/// Errors: no such file, unknown or broken format.
Result<Metadata> readMetadata(const std::filesystem::path& path);

}  // namespace soffit::io

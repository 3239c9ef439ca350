// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/io/image/read_image.h"
#include "core/scene/material.h"

#include <filesystem>

/// Writing pictures, whole or not at all.
namespace soffit::io {

struct WriteOptions {
  Metadata metadata;    ///< "Software: Soffit x.y.z" is added; line breaks become spaces
  int bits = 8;         ///< .tif and .png: 8 or 16
  int quality = 95;     ///< .jpg: 1..100
  bool dither = false;  ///< 8 bit: hide the steps of smooth gradients
};

/// Whether the file's format holds scene-linear floats (.exr, .hdr) rather than code values.
bool isSceneLinear(const std::filesystem::path& path);

/// Whether writeImage() knows the file's extension: .png .jpg .jpeg .tif .tiff .exr .hdr.
Result<void> checkImagePath(const std::filesystem::path& path);

/// Writes 1 or 3 channels. Values are written as they stand: display code values 0..1 to .png,
/// .jpg, .tif (clamped, NaN as 0), linear floats to .exr (float) and .hdr (shared exponent).
/// An existing file is replaced only when the new one is complete.
/// Errors: unknown extension, picture without pixels, folder missing or not writable, disk full.
Result<void> writeImage(const std::filesystem::path& path, const scene::Image& image,
                        const WriteOptions& options = {});

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/render/film.h"
#include "core/render/picture.h"

#include <filesystem>

namespace soffit::cli {

/// Writes a film: through the view transform to .png, .jpg and .tif; scene-linear, without
/// exposure, to .exr and .hdr: cd/m^2, or lux in all channels when the view is false colour.
/// facts.view and facts.exposure_ev are taken from the options.
/// Errors: see render::developPicture() and io::writeImage().
Result<void> writePicture(const std::filesystem::path& path, const render::Film& film,
                          const render::PictureOptions& options, render::PictureFacts facts);

}  // namespace soffit::cli

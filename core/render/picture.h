// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/color/display_transform.h"
#include "core/color/false_color.h"
#include "core/render/bloom.h"
#include "core/render/film.h"
#include "core/scene/material.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace soffit::render {

struct PictureOptions {
  color::DisplayChoice display;  ///< the view `False colour` shows lux instead of luminance
  double exposure_ev = 0.0;      ///< false colour ignores it
  color::ToneSettings tone;      ///< of the views that adapt
  /// What those adapt to; absent: the film. Pictures that are compared share one.
  std::optional<color::PictureLuminance> adapted_to;
  Bloom bloom;  ///< false colour ignores it
  std::optional<color::FalseColorRange>
      range;           ///< false colour; absent: from 0 to what the picture holds
  bool legend = true;  ///< false colour
  std::string title;   ///< printed into the lower left corner; may be empty
};

/// Turns a film into display code values, 3 channels: through the view transform, or in false
/// colour with luminaires in white and what lies beyond the scene in dark grey.
/// Errors: see DisplayTransform::create() and FalseColorRange::check().
Result<scene::Image> developPicture(const Film& film, const PictureOptions& options);

/// The film's luminances as they are, cd/m^2, for scene-linear files.
scene::Image linearPicture(const Film& film);

/// The range that developPicture() takes without one: linear, from 0 to a round value that covers
/// all but the brightest two percent of the surfaces.
color::FalseColorRange fittingRange(const Film& film);

/// What a picture shows, for its metadata.
struct PictureFacts {
  std::string project;
  std::string layout;
  std::string camera;
  std::string view;
  double exposure_ev = 0.0;
  double white_balance = 0.0;   ///< kelvin, 0: daylight
  std::string unit = "cd/m2";  ///< of scene-linear files
};

/// Keys and values in the order Project, Layout, Camera, View, Exposure, White balance; scene-linear
/// files have "Unit" in place of the last three. Empty values are left out.
std::vector<std::pair<std::string, std::string>> pictureMetadata(const PictureFacts& facts,
                                                                 bool scene_linear);

}  // namespace soffit::render

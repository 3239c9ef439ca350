// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

/// Finds and describes the OpenColorIO config.
namespace soffit::color {

/// The folder that `relative` ("ocio", say) lies in among the program's resources:
/// $SOFFIT_RESOURCES, else ../share/soffit beside the executable (install tree and build tree),
/// else the nearest `resources` folder above the executable (a source tree).
/// Errors: found nowhere; names what was tried.
Result<std::filesystem::path> findResource(const std::filesystem::path& relative);

/// The OCIO config to use: $OCIO if set and not empty, else ocio/config.ocio of the resources.
Result<std::filesystem::path> findDisplayConfig();

/// The displays and looks of a config, in its order. Errors: unreadable config.
struct DisplayNames {
  std::vector<std::string> displays;
  std::vector<std::string> looks;
};
Result<DisplayNames> displaysOf(const std::filesystem::path& config);

/// The views of a display, in the config's order, and those that adapt to the picture
/// (tone_operator.h), which need the config's kPlainView. Errors: unreadable config, unknown
/// display.
Result<std::vector<std::string>> viewsOf(const std::filesystem::path& config,
                                         const std::string& display);

}  // namespace soffit::color

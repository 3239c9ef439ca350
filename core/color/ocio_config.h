// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// OpenColorIO's objects behind opaque handles, for the sources of this module.
namespace soffit::color {

/// A loaded config. The pointee is an OpenColorIO::Config.
struct OcioConfig {
  std::shared_ptr<const void> config;
  std::string path;
};

/// Errors: missing or malformed file (OCIO's own words, on one line).
Result<OcioConfig> loadConfig(const std::filesystem::path& path);

/// Errors: a display that the config lacks; names those it has.
Result<std::vector<std::string>> viewNames(const OcioConfig& config, const std::string& display);

/// Errors: as viewNames(); a view or look that the config lacks; names those it has.
Result<void> checkView(const OcioConfig& config, const std::string& display,
                       const std::string& view, const std::string& look);

/// The config at `path` (empty: findDisplayConfig()), known to have that view.
/// Errors: findDisplayConfig(), loadConfig() and checkView().
Result<OcioConfig> loadConfigFor(const std::filesystem::path& path, const std::string& display,
                                 const std::string& view, const std::string& look);

/// From scene-linear to the display's code values, through a view that the config has. white: what
/// whiteBalance() takes. The pointee is an OpenColorIO::Processor, alive as long as the config.
/// Throws OpenColorIO's exceptions.
std::shared_ptr<const void> viewProcessor(const OcioConfig& config, const std::string& display,
                                          const std::string& view, const std::string& look,
                                          double white = 0.0);

/// Errors: none. Names in the config's order.
std::vector<std::string> displayNames(const OcioConfig& config);
std::vector<std::string> lookNames(const OcioConfig& config);

}  // namespace soffit::color

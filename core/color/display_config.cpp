// SPDX-License-Identifier: MIT
#include "core/color/display_config.h"

#include "core/color/display_transform.h"
#include "core/color/ocio_config.h"
#include "core/color/tone_operator.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace soffit::color {
namespace {

namespace fs = std::filesystem;

std::string environmentVariable(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets it
  return value == nullptr ? std::string() : std::string(value);
}

bool isThere(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

fs::path executableFolder() {
  std::error_code failed;
  const fs::path self = fs::read_symlink("/proc/self/exe", failed);
  return failed ? fs::path() : self.parent_path();
}

}  // namespace

Result<fs::path> findResource(const fs::path& relative) {
  const std::string chosen = environmentVariable("SOFFIT_RESOURCES");
  if (!chosen.empty()) {
    if (isThere(fs::path(chosen) / relative)) return fs::path(chosen) / relative;
    return Error{"SOFFIT_RESOURCES=" + chosen,
                 "there is no " + relative.string() + " in this folder",
                 "Unset the variable, or let it name the folder that holds Soffit's resources."};
  }
  const fs::path folder = executableFolder();
  const fs::path installed = folder / ".." / "share" / "soffit" / relative;
  if (isThere(installed)) return installed.lexically_normal();
  for (fs::path above = folder; above.has_relative_path(); above = above.parent_path()) {
    if (isThere(above / "resources" / relative)) return above / "resources" / relative;
  }
  return Error{relative.string(),
               "not found in " + installed.lexically_normal().string() +
                   " nor in a resources folder above the program",
               "Install Soffit again, or set SOFFIT_RESOURCES to its resources folder."};
}

Result<fs::path> findDisplayConfig() {
  const std::string chosen = environmentVariable("OCIO");
  if (!chosen.empty()) return fs::path(chosen);
  return findResource(fs::path("ocio") / "config.ocio");
}

Result<DisplayNames> displaysOf(const fs::path& config) {
  const Result<OcioConfig> loaded = loadConfig(config);
  if (!loaded) return loaded.error();
  return DisplayNames{displayNames(*loaded), lookNames(*loaded)};
}

Result<std::vector<std::string>> viewsOf(const fs::path& config, const std::string& display) {
  const Result<OcioConfig> loaded = loadConfig(config);
  if (!loaded) return loaded.error();
  auto names = viewNames(*loaded, display);
  if (names && std::ranges::find(*names, kPlainView) != names->end()) {
    // Before false colour, which stands last.
    const auto at = std::ranges::find(*names, kFalseColorView);
    names->insert(at, {kReinhard2002View, kTumblinRushmeierView});
  }
  return names;
}

}  // namespace soffit::color

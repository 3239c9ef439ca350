// SPDX-License-Identifier: MIT
#include "core/color/ocio_config.h"

#include "core/color/display_config.h"
#include "core/color/white_balance.h"

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <system_error>

namespace soffit::color {
namespace {

namespace ocio = OCIO_NAMESPACE;

const ocio::Config& configOf(const OcioConfig& config) {
  return *static_cast<const ocio::Config*>(config.config.get());
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Error unknown(const OcioConfig& config, const char* kind, const std::string& name,
              const std::vector<std::string>& known) {
  const std::string list =
      known.empty() ? "It has none." : fmt::format("It has: {}.", fmt::join(known, ", "));
  return {config.path, fmt::format("the OCIO config has no {} \"{}\"", kind, name), list};
}

/// White balance; what it takes out of Rec.709 is clipped.
ocio::TransformRcPtr balanceTransform(double kelvin) {
  const dmat3 balance = whiteBalance(kelvin);
  std::array<double, 16> rows{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      rows[static_cast<std::size_t>(4 * row + column)] = balance[column][row];
    }
  }
  rows[15] = 1.0;
  const auto matrix = ocio::MatrixTransform::Create();
  matrix->setMatrix(rows.data());
  const auto clip = ocio::RangeTransform::Create();
  clip->setMinInValue(0.0);
  clip->setMinOutValue(0.0);
  const auto both = ocio::GroupTransform::Create();
  both->appendTransform(matrix);
  both->appendTransform(clip);
  return both;
}

}  // namespace

Result<OcioConfig> loadConfig(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    return Error{path.string(), "the OCIO config does not exist",
                 "Unset $OCIO to use Soffit's own, or let it name a config.ocio."};
  }
  try {
    ocio::SetLoggingLevel(ocio::LOGGING_LEVEL_NONE);  // a library of ours does not print
    ocio::ConstConfigRcPtr config = ocio::Config::CreateFromFile(path.string().c_str());
    return OcioConfig{config, path.string()};
  } catch (const std::exception& e) {
    return Error{path.string(), fmt::format("the OCIO config cannot be read ({})", e.what()),
                 "Unset $OCIO to use Soffit's own."};
  }
}

std::vector<std::string> displayNames(const OcioConfig& config) {
  const ocio::Config& c = configOf(config);
  std::vector<std::string> displays;
  displays.reserve(static_cast<std::size_t>(c.getNumDisplays()));
  for (int i = 0; i < c.getNumDisplays(); ++i) displays.emplace_back(c.getDisplay(i));
  return displays;
}

std::vector<std::string> lookNames(const OcioConfig& config) {
  const ocio::Config& c = configOf(config);
  std::vector<std::string> looks;
  looks.reserve(static_cast<std::size_t>(c.getNumLooks()));
  for (int i = 0; i < c.getNumLooks(); ++i) looks.emplace_back(c.getLookNameByIndex(i));
  return looks;
}

Result<std::vector<std::string>> viewNames(const OcioConfig& config, const std::string& display) {
  const ocio::Config& c = configOf(config);
  const std::vector<std::string> displays = displayNames(config);
  if (!contains(displays, display)) return unknown(config, "display", display, displays);
  std::vector<std::string> views;
  views.reserve(static_cast<std::size_t>(c.getNumViews(display.c_str())));
  for (int i = 0; i < c.getNumViews(display.c_str()); ++i) {
    views.emplace_back(c.getView(display.c_str(), i));
  }
  return views;
}

Result<void> checkView(const OcioConfig& config, const std::string& display,
                       const std::string& view, const std::string& look) {
  const auto views = viewNames(config, display);
  if (!views) return views.error();
  if (!contains(*views, view)) return unknown(config, "view", view, *views);
  if (look.empty()) return {};
  const std::vector<std::string> looks = lookNames(config);
  if (!contains(looks, look)) return unknown(config, "look", look, looks);
  return {};
}

Result<OcioConfig> loadConfigFor(const std::filesystem::path& path, const std::string& display,
                                 const std::string& view, const std::string& look) {
  std::filesystem::path file = path;
  if (file.empty()) {
    const auto found = findDisplayConfig();
    if (!found) return found.error();
    file = *found;
  }
  auto config = loadConfig(file);
  if (!config) return config.error();
  if (const auto known = checkView(*config, display, view, look); !known) return known.error();
  return config;
}

std::shared_ptr<const void> viewProcessor(const OcioConfig& config, const std::string& display,
                                          const std::string& view, const std::string& look,
                                          double white) {
  auto transform = ocio::DisplayViewTransform::Create();
  transform->setSrc(ocio::ROLE_SCENE_LINEAR);
  transform->setDisplay(display.c_str());
  transform->setView(view.c_str());
  auto pipeline = ocio::LegacyViewingPipeline::Create();
  pipeline->setDisplayViewTransform(transform);
  if (white > 0.0) pipeline->setLinearCC(balanceTransform(white));
  if (!look.empty()) {
    pipeline->setLooksOverrideEnabled(true);
    pipeline->setLooksOverride(look.c_str());
  }
  const auto shared = std::static_pointer_cast<const ocio::Config>(config.config);
  return pipeline->getProcessor(shared);
}

}  // namespace soffit::color

// SPDX-License-Identifier: MIT
#include "core/render/picture.h"

#include "core/base/parallel.h"
#include "core/render/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace soffit::render {
namespace {

constexpr vec3 kLampWhite{0.97F};
constexpr vec3 kBeyond{0.13F};

scene::Image toImage(const Film& film, const std::vector<vec3>& pixels) {
  scene::Image image{film.width, film.height, 3, {}};
  image.pixels.resize(3 * pixels.size());
  static_assert(sizeof(vec3) == 3 * sizeof(float));
  if (!pixels.empty())
    std::memcpy(image.pixels.data(), pixels.data(), pixels.size() * sizeof(vec3));
  return image;
}

std::vector<vec3> falseColors(const Film& film, const color::FalseColorRange& range) {
  std::vector<vec3> pixels(film.count());
  parallelFor(pixels.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float beyond = 1.0F - film.surface[i] - film.lamp[i];
      pixels[i] = film.surface[i] * color::falseColor(film.lux[i], range) +
                  film.lamp[i] * kLampWhite + std::max(beyond, 0.0F) * kBeyond;
    }
  });
  return pixels;
}

}  // namespace

color::FalseColorRange fittingRange(const Film& film) {
  std::vector<float> lux;
  lux.reserve(film.count());
  for (std::size_t i = 0; i < film.count(); ++i) {
    if (film.surface[i] > 0.5F) lux.push_back(film.lux[i]);
  }
  if (lux.empty()) return color::roundRange(0.0);
  const auto rank = static_cast<std::ptrdiff_t>(lux.size() - 1 - lux.size() / 50);
  std::nth_element(lux.begin(), lux.begin() + rank, lux.end());
  return color::roundRange(static_cast<double>(lux[static_cast<std::size_t>(rank)]));
}

Result<scene::Image> developPicture(const Film& film, const PictureOptions& options) {
  scene::Image image;
  if (options.display.view == color::kFalseColorView) {
    const color::FalseColorRange range = options.range.value_or(fittingRange(film));
    const auto valid = range.check();
    if (!valid) return valid.error();
    image = toImage(film, falseColors(film, range));
    if (options.legend) drawLegend(image, range);
  } else {
    color::DisplayChoice choice = options.display;
    if (const auto kind = color::toneKindOf(choice.view)) {
      choice.tone = color::makeToneOperator(
          *kind, options.adapted_to.value_or(color::pictureLuminance(film.radiance)), options.tone);
    }
    const auto transform = color::DisplayTransform::create(choice);
    if (!transform) return transform.error();
    std::vector<vec3> radiance = film.radiance;
    addBloom(radiance, film.width, film.height, options.bloom);
    std::vector<vec3> pixels(film.count());
    transform->apply(radiance, options.exposure_ev, pixels);
    image = toImage(film, pixels);
  }
  drawTitle(image, options.title);
  return image;
}

scene::Image linearPicture(const Film& film) {
  return toImage(film, film.radiance);
}

std::vector<std::pair<std::string, std::string>> pictureMetadata(const PictureFacts& facts,
                                                                 bool scene_linear) {
  std::vector<std::pair<std::string, std::string>> lines;
  const auto add = [&](const char* key, const std::string& value) {
    if (!value.empty()) lines.emplace_back(key, value);
  };
  add("Project", facts.project);
  add("Layout", facts.layout);
  add("Camera", facts.camera);
  if (scene_linear) {
    add("Unit", facts.unit);
  } else {
    add("View", facts.view);
    add("Exposure", fmt::format("{:g} EV", facts.exposure_ev));
    if (facts.white_balance > 0.0) {
      add("White balance", fmt::format("{:g} K", facts.white_balance));
    }
  }
  return lines;
}

}  // namespace soffit::render

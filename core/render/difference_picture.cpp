// SPDX-License-Identifier: MIT
#include "core/render/difference_picture.h"

#include "core/base/parallel.h"
#include "core/color/false_color.h"
#include "core/render/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::render {
namespace {

constexpr vec3 kLamp{0.55F};
constexpr vec3 kBeyond{0.13F};

/// From far below to far above, evenly spaced.
constexpr std::array<vec3, 9> kAnchors{{{0.05F, 0.16F, 0.38F},
                                        {0.13F, 0.36F, 0.64F},
                                        {0.38F, 0.59F, 0.80F},
                                        {0.69F, 0.82F, 0.91F},
                                        {0.96F, 0.96F, 0.95F},
                                        {0.96F, 0.79F, 0.60F},
                                        {0.89F, 0.55F, 0.25F},
                                        {0.67F, 0.34F, 0.06F},
                                        {0.39F, 0.19F, 0.02F}}};

float differenceAt(const Film& first, const Film& second, std::size_t i) {
  return second.lux[i] - first.lux[i];
}

/// Surfaces seen in both films.
float surfaceAt(const Film& first, const Film& second, std::size_t i) {
  return std::min(first.surface[i], second.surface[i]);
}

}  // namespace

vec3 differenceColor(float place) {
  if (std::isnan(place)) place = 0.0F;
  const float at = 0.5F * (std::clamp(place, -1.0F, 1.0F) + 1.0F) * (kAnchors.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kAnchors.size() - 2);
  const float share = at - static_cast<float>(below);
  return (1.0F - share) * kAnchors[below] + share * kAnchors[below + 1];
}

std::vector<color::LegendTick> differenceTicks(double range, int most) {
  // Ticks of the positive half, mirrored.
  std::vector<color::LegendTick> ticks;
  for (const auto& tick :
       color::legendTicks({.min = 0.0, .max = range}, std::max(2, (most + 1) / 2))) {
    const float half = 0.5F * tick.place;
    if (tick.lux > 0.0) ticks.push_back({-tick.lux, 0.5F - half, "\u2212" + tick.label});
    ticks.push_back({tick.lux, 0.5F + half, (tick.lux > 0.0 ? "+" : "") + tick.label});
  }
  std::sort(ticks.begin(), ticks.end(), [](const auto& a, const auto& b) { return a.lux < b.lux; });
  return ticks;
}

double fittingDifference(const Film& first, const Film& second) {
  std::vector<float> size;
  for (std::size_t i = 0; i < std::min(first.count(), second.count()); ++i) {
    if (surfaceAt(first, second, i) > 0.5F)
      size.push_back(std::abs(differenceAt(first, second, i)));
  }
  if (size.empty()) return 1.0;
  const auto rank = static_cast<std::ptrdiff_t>(size.size() - 1 - size.size() / 50);
  std::nth_element(size.begin(), size.begin() + rank, size.end());
  return color::roundRange(static_cast<double>(size[static_cast<std::size_t>(rank)])).max;
}

Result<scene::Image> differencePicture(const Film& first, const Film& second,
                                       const DifferenceOptions& options) {
  if (first.width != second.width || first.height != second.height) {
    return Error{"difference picture",
                 fmt::format("the pictures have different sizes, {}x{} and {}x{}", first.width,
                             first.height, second.width, second.height),
                 "Render both at one size."};
  }
  const double range = options.range_lux.value_or(fittingDifference(first, second));
  if (!(range > 0.0) || !std::isfinite(range)) {
    return Error{"difference picture", fmt::format("expected a range above 0 lx, found {}", range),
                 "Leave the range out to have it chosen."};
  }
  scene::Image image{first.width, first.height, 3, {}};
  image.pixels.resize(3 * first.count());
  parallelFor(first.count(), 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float surface = surfaceAt(first, second, i);
      const float lamp = std::min(std::max(first.lamp[i], second.lamp[i]), 1.0F - surface);
      const float place = differenceAt(first, second, i) / static_cast<float>(range);
      const vec3 pixel = surface * differenceColor(place) + lamp * kLamp +
                         std::max(0.0F, 1.0F - surface - lamp) * kBeyond;
      for (std::size_t c = 0; c < 3; ++c) image.pixels[3 * i + c] = pixel[static_cast<int>(c)];
    }
  });
  if (options.legend) {
    drawLegend(image, LegendScale{[](float place) { return differenceColor(2.0F * place - 1.0F); },
                                  differenceTicks(range, legendRoom(image))});
  }
  drawTitle(image, options.title);
  return image;
}

}  // namespace soffit::render

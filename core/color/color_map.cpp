// SPDX-License-Identifier: MIT
#include "core/color/color_map.h"

#include "core/color/false_color.h"
#include "core/color/srgb.h"

#include <algorithm>
#include <cmath>

namespace soffit::color {
namespace {

using Points = std::array<vec3, kColorMapPoints>;

/// Ends of blue_yellow in Oklab (L, a, b): as far apart as sRGB allows on a line of one hue pair.
constexpr dvec3 kBlue{0.26, -0.005, -0.10};
constexpr dvec3 kYellow{0.91, -0.02, 0.15};
/// Ends of grey: black and white stay free for what is no surface.
constexpr double kDarkGrey = 0.22;
constexpr double kLightGrey = 0.95;

/// Ottosson 2020, "A perceptual color space for image processing".
vec3 codeFromOklab(const dvec3& lab) {
  const auto cubed = [](double x) { return x * x * x; };
  const double l = cubed(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z);
  const double m = cubed(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z);
  const double s = cubed(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z);
  const dvec3 linear(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                     -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                     -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s);
  vec3 code;
  for (int c = 0; c < 3; ++c) {
    code[c] = srgbEncode(static_cast<float>(std::clamp(linear[c], 0.0, 1.0)));
  }
  return code;
}

/// Red, green and blue are trapezia over the place, a quarter of it each way: linear between
/// multiples of an eighth, so exact at 33 points.
vec3 spectrumAt(double place) {
  const auto trapezium = [place](double middle) {
    return static_cast<float>(std::clamp(1.5 - std::abs(4.0 * place - middle), 0.0, 1.0));
  };
  return {trapezium(3.0), trapezium(2.0), trapezium(1.0)};
}

vec3 pointOf(ColorMap map, double place) {
  switch (map) {
    case ColorMap::violet_yellow:
      return falseColorAt(static_cast<float>(place));
    case ColorMap::blue_yellow:
      return codeFromOklab(glm::mix(kBlue, kYellow, place));
    case ColorMap::grey:
      return codeFromOklab({glm::mix(kDarkGrey, kLightGrey, place), 0.0, 0.0});
    case ColorMap::spectrum:
      return spectrumAt(place);
  }
  return vec3(0.0F);
}

Points pointsOf(ColorMap map) {
  Points points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = pointOf(map, static_cast<double>(i) / static_cast<double>(points.size() - 1));
  }
  return points;
}

}  // namespace

const Points& colorMapPoints(ColorMap map) {
  static const std::array<Points, kColorMaps.size()> kAll{
      pointsOf(ColorMap::violet_yellow), pointsOf(ColorMap::blue_yellow), pointsOf(ColorMap::grey),
      pointsOf(ColorMap::spectrum)};
  return kAll[static_cast<std::size_t>(map)];
}

vec3 colorMapAt(ColorMap map, float place) {
  const Points& points = colorMapPoints(map);
  const float clamped = std::min(std::max(0.0F, place), 1.0F);  // NaN becomes 0
  const float x = clamped * static_cast<float>(points.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(x), points.size() - 2);
  return glm::mix(points[i], points[i + 1], x - static_cast<float>(i));
}

}  // namespace soffit::color

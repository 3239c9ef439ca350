// SPDX-License-Identifier: MIT
#include "core/color/tone_operator.h"

#include "core/color/exposure.h"
#include "core/color/luminance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace soffit::color {
namespace {

constexpr double kDisplayWhite = 100.0;  // cd/m^2
constexpr double kDisplayContrast = 35.0;
constexpr float kBrightest = 1.0e6F;

/// Stevens' sensitivity to contrast at an adaptation luminance in cd/m^2.
double sensitivity(double luminance) {
  return luminance > 100.0 ? 2.655 : 1.855 + 0.4 * std::log10(luminance + 2.3e-5);
}

ToneOperator reinhard2002(const PictureLuminance& picture, const ToneSettings& settings) {
  const double least = std::log2(picture.least);
  const double most = std::log2(picture.most);
  const double average = std::log2(picture.log_average);
  double key = settings.key;
  if (key <= 0.0) {
    // An even picture has neither a low key nor a high one.
    const double place =
        most - least > 1e-3 ? (2.0 * average - least - most) / (most - least) : 0.0;
    key = kMidGrey * std::pow(4.0, std::clamp(place, -1.0, 1.0));
  }
  double white = settings.white;
  if (white <= 0.0) white = std::clamp(1.5 * std::exp2(most - least - 5.0), 1.0, 1e6);
  return {ToneKind::reinhard_2002,
          static_cast<float>(key * kReferenceLuminance / picture.log_average),
          static_cast<float>(1.0 / (white * white))};
}

ToneOperator tumblinRushmeier(const PictureLuminance& picture) {
  const double display = kDisplayWhite / std::sqrt(kDisplayContrast);  // L_da
  const double world = picture.log_average;                            // L_wa
  const double flat = sensitivity(world) / (1.855 + 0.4 * std::log10(display));
  const double m = std::pow(std::sqrt(kDisplayContrast), flat - 1.0);
  const double power = sensitivity(world) / sensitivity(display);
  const double scale = m * display / kDisplayWhite * std::pow(kReferenceLuminance / world, power);
  return {ToneKind::tumblin_rushmeier, static_cast<float>(scale), static_cast<float>(power)};
}

}  // namespace

std::optional<ToneKind> toneKindOf(const std::string& view) {
  if (view == kReinhard2002View) return ToneKind::reinhard_2002;
  if (view == kTumblinRushmeierView) return ToneKind::tumblin_rushmeier;
  return std::nullopt;
}

PictureLuminance pictureLuminance(std::span<const vec3> radiance, std::size_t step) {
  std::vector<float> values;
  values.reserve(radiance.size() / step + 1);
  for (std::size_t i = 0; i < radiance.size(); i += step) {
    const float y = luminance(radiance[i]);
    if (y > 1.0e-6F && std::isfinite(y)) values.push_back(y);
  }
  if (values.empty()) return {};
  // Sorted, so that the sum does not depend on the order of the pixels.
  std::ranges::sort(values);
  const std::size_t out = values.size() / 100;
  const std::span<const float> kept(values.data() + out, values.size() - 2 * out);
  double sum = 0.0;
  for (const float y : kept) sum += std::log(static_cast<double>(y));
  return {std::exp(sum / static_cast<double>(kept.size())), static_cast<double>(kept.front()),
          static_cast<double>(kept.back())};
}

float ToneOperator::displayed(float y) const {
  if (!(y > 0.0F)) return 0.0F;
  y = std::min(y, kBrightest);
  if (kind == ToneKind::tumblin_rushmeier) return a * std::pow(y, b);
  const float s = a * y;
  return s * (1.0F + s * b) / (1.0F + s);
}

vec3 ToneOperator::displayed(const vec3& rgb) const {
  const float y = std::min(luminance(rgb), kBrightest);
  if (!(y > 0.0F)) return vec3(0.0F);
  return glm::max(rgb * (displayed(y) / y), vec3(0.0F));
}

ToneOperator makeToneOperator(ToneKind kind, const PictureLuminance& picture,
                              const ToneSettings& settings) {
  return kind == ToneKind::reinhard_2002 ? reinhard2002(picture, settings)
                                         : tumblinRushmeier(picture);
}

std::string toneShader(ToneKind kind) {
  const char* curve = kind == ToneKind::tumblin_rushmeier
                          ? "soffit_tone.x * pow(y, soffit_tone.y)"
                          : "s * (1.0 + s * soffit_tone.y) / (1.0 + s)";
  const dvec3 w = kLuminanceRec709;
  return fmt::format(
      "uniform vec2 soffit_tone;\n"
      "vec3 soffitTone(vec3 rgb) {{\n"
      "  float y = min(dot(rgb, vec3({:.9f}, {:.9f}, {:.9f})), {:.1f});\n"
      "  if (!(y > 0.0)) return vec3(0.0);\n"
      "  float s = soffit_tone.x * y;\n"
      "  return max(rgb * (({}) / y), vec3(0.0));\n"
      "}}\n",
      w.x, w.y, w.z, static_cast<double>(kBrightest), curve);
}

}  // namespace soffit::color

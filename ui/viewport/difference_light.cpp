// SPDX-License-Identifier: MIT
#include "ui/viewport/difference_light.h"

#include "core/color/false_color.h"
#include "core/color/luminance.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

float luxAt(const relight::Planes& lux, std::size_t slot) {
  return color::luminance(vec3(lux[0][slot], lux[1][slot], lux[2][slot]));
}

}  // namespace

LightFramePtr differenceLight(const LightFrame& first, const LightFrame& second, double range) {
  auto light = std::make_shared<LightFrame>();
  light->solver = second.solver;
  light->revision = second.revision;
  const std::size_t slots = std::min(first.lux[0].size(), second.lux[0].size());
  const auto half = static_cast<float>(range);
  std::vector<float> shifted(slots);
  for (std::size_t s = 0; s < slots; ++s) {
    shifted[s] = half + std::clamp(luxAt(second.lux, s) - luxAt(first.lux, s), -half, half);
  }
  light->lux = {shifted, shifted, shifted};
  return light;
}

double fittingDifference(const LightFrame& first, const LightFrame& second) {
  std::vector<float> sizes;
  const std::size_t slots = std::min(first.lux[0].size(), second.lux[0].size());
  for (std::size_t s = 0; s < slots; s += 3) {
    sizes.push_back(std::abs(luxAt(second.lux, s) - luxAt(first.lux, s)));
  }
  if (sizes.empty()) return 1.0;
  const auto rank = static_cast<std::ptrdiff_t>(sizes.size() - 1 - sizes.size() / 50);
  std::nth_element(sizes.begin(), sizes.begin() + rank, sizes.end());
  const double most = static_cast<double>(sizes[static_cast<std::size_t>(rank)]);
  return most > 0.0 ? color::roundRange(most).max : 1.0;
}

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#include "core/scene/roughness.h"

#include <algorithm>

namespace soffit::scene {

RoughnessRange roughnessRange(const Material& material) {
  constexpr int kMost = 512;
  const double r = material.roughness;
  const Image* map = material.roughness_image.get();
  if (map == nullptr || map->pixels.empty() || map->channels < 2) return {r, r};
  const int step_x = (map->width + kMost - 1) / kMost;
  const int step_y = (map->height + kMost - 1) / kMost;
  double least = 1.0;
  double sum = 0.0;
  std::size_t count = 0;
  for (int y = 0; y < map->height; y += step_y) {
    for (int x = 0; x < map->width; x += step_x) {
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(map->width) +
                         static_cast<std::size_t>(x);
      const double share = std::clamp(
          static_cast<double>(map->pixels[pixel * static_cast<std::size_t>(map->channels) + 1]),
          0.0, 1.0);
      least = std::min(least, share);
      sum += share;
      ++count;
    }
  }
  return {r * least, r * sum / static_cast<double>(count)};
}

}  // namespace soffit::scene

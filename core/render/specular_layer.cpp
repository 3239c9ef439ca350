// SPDX-License-Identifier: MIT
#include "core/render/specular_layer.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::render {
namespace {

/// Narrower lobes are left as sharp as they are.
constexpr float kSharpAlpha = 0.02F;

/// One tap per phase and axis: the outer two share a phase.
constexpr std::array<float, 5> kWeights{0.5F, 1.0F, 1.0F, 1.0F, 0.5F};

bool belongTogether(const SpecularLayer::Pixel& a, const SpecularLayer::Pixel& b) {
  if (b.coverage <= 0.0F || a.material != b.material) return false;
  if (glm::dot(a.normal, b.normal) < 0.97F) return false;
  const vec3 d = b.position - a.position;
  // In one plane, up to the curvature that the normals allow.
  return std::abs(glm::dot(d, a.normal)) <= 0.15F * glm::length(d) + 1.0e-4F;
}

vec3 smoothed(const SpecularLayer& layer, int x, int y) {
  const auto at = [&](int i, int j) -> const SpecularLayer::Pixel& {
    return layer.pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(layer.width) +
                        static_cast<std::size_t>(i)];
  };
  const SpecularLayer::Pixel& own = at(x, y);
  if (own.alpha < kSharpAlpha) return own.radiance;
  vec3 sum(0.0F);
  float weights = 0.0F;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const int i = x + dx;
      const int j = y + dy;
      if (i < 0 || j < 0 || i >= layer.width || j >= layer.height) continue;
      const SpecularLayer::Pixel& other = at(i, j);
      if (!belongTogether(own, other)) continue;
      const float w =
          kWeights[static_cast<std::size_t>(dx + 2)] * kWeights[static_cast<std::size_t>(dy + 2)];
      sum += w * other.radiance;
      weights += w;
    }
  }
  return sum / weights;  // the pixel itself always counts
}

}  // namespace

void addReflections(const SpecularLayer& layer, Film& film) {
  if (layer.pixels.empty()) return;
  parallelFor(static_cast<std::size_t>(film.height), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < film.width; ++x) {
        const float coverage = layer.pixels[film.at(x, y)].coverage;
        if (coverage > 0.0F) film.radiance[film.at(x, y)] += coverage * smoothed(layer, x, y);
      }
    }
  });
}

}  // namespace soffit::render

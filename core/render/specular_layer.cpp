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

/// Share of a block's weight from which on its mean stands for the pixel.
constexpr float kEnough = 0.75F;
/// Of a lobe's alpha: how far another's may be off and still be the same (roughness maps).
constexpr float kSameAlpha = 0.1F;
/// Angle between normals within which two pixels have one lobe, in units of alpha, and at most,
/// rad.
constexpr float kSameLobe = 0.25F;
constexpr float kMostTurn = 0.25F;

bool belongTogether(const SpecularLayer::Pixel& a, const SpecularLayer::Pixel& b) {
  if (b.coverage <= 0.0F || a.material != b.material || b.whole) return false;
  if (std::abs(a.alpha - b.alpha) > kSameAlpha * a.alpha) return false;
  const float turn = std::min(kSameLobe * a.alpha, kMostTurn);
  // 1 - cos by half the square of the difference, which keeps its digits for small angles.
  const vec3 apart = a.normal - b.normal;
  if (glm::dot(apart, apart) > turn * turn) return false;
  const vec3 d = b.position - a.position;
  // In one plane, up to the curvature that the normals allow.
  return std::abs(glm::dot(d, a.normal)) <= 0.15F * glm::length(d) + 1.0e-4F;
}

const SpecularLayer::Pixel& pixelAt(const SpecularLayer& layer, int x, int y) {
  return layer.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(layer.width) +
                      static_cast<std::size_t>(x)];
}

/// visit(pixel, weight) for those of a block about a pixel that belong to it.
template <class Visit>
void visitBlock(const SpecularLayer& layer, int x, int y, const Visit& visit) {
  const SpecularLayer::Pixel& own = pixelAt(layer, x, y);
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const int i = x + dx;
      const int j = y + dy;
      if (i < 0 || j < 0 || i >= layer.width || j >= layer.height) continue;
      const SpecularLayer::Pixel& other = pixelAt(layer, i, j);
      if (!belongTogether(own, other)) continue;
      visit(other, kWeights[static_cast<std::size_t>(dx + 2)] *
                       kWeights[static_cast<std::size_t>(dy + 2)]);
    }
  }
}

vec3 smoothed(const SpecularLayer& layer, int x, int y) {
  const SpecularLayer::Pixel& own = pixelAt(layer, x, y);
  if (own.alpha < kSharpAlpha || own.whole) return own.radiance;
  vec3 sum(0.0F);
  float weights = 0.0F;
  visitBlock(layer, x, y, [&](const SpecularLayer::Pixel& other, float w) {
    sum += w * other.radiance;
    weights += w;
  });
  return sum / weights;  // the pixel itself always counts
}

}  // namespace

bool smooths(const SpecularLayer& layer, int x, int y) {
  const SpecularLayer::Pixel& own = pixelAt(layer, x, y);
  return own.coverage > 0.0F && own.alpha >= kSharpAlpha && !own.whole;
}

bool standsAlone(const SpecularLayer& layer, int x, int y) {
  if (!smooths(layer, x, y)) return false;
  constexpr float kWhole = static_cast<float>(kPhases * kPhases);
  float weights = 0.0F;
  visitBlock(layer, x, y, [&](const SpecularLayer::Pixel&, float w) { weights += w; });
  return weights < kEnough * kWhole;
}

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

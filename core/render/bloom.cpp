// SPDX-License-Identifier: MIT
#include "core/render/bloom.h"

#include "core/base/parallel.h"
#include "core/color/luminance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace soffit::render {
namespace {

struct Lobe {
  double deviation;  // of the picture's height
  float share;
};
constexpr std::array<Lobe, 3> kLobes{{{0.004, 0.5F}, {0.016, 0.3F}, {0.06, 0.2F}}};
constexpr int kPasses = 5;

/// Half widths of the means whose variances add up to that of the Gaussian, as nearly as whole
/// pixels can: (w^2 - 1) / 12 each.
std::array<int, kPasses> halfWidths(double deviation) {
  const double ideal = std::sqrt(12.0 * deviation * deviation / kPasses + 1.0);
  int lower = static_cast<int>(ideal);
  if (lower % 2 == 0) --lower;
  lower = std::max(lower, 1);
  const double more = (12.0 * deviation * deviation -
                       kPasses * (static_cast<double>(lower) * lower + 4.0 * lower + 3.0)) /
                      (-4.0 * lower - 4.0);
  const int narrow = std::clamp(static_cast<int>(std::lround(more)), 0, kPasses);
  std::array<int, kPasses> half{};
  for (int k = 0; k < kPasses; ++k) {
    half[static_cast<std::size_t>(k)] = (k < narrow ? lower : lower + 2) / 2;
  }
  return half;
}

/// A running mean over 2 half + 1 values; beyond the ends it is black. Sums in double: a lamp
/// leaves no trace behind where it has passed.
void meanOf(std::span<const vec3> from, std::span<vec3> to, int half) {
  const auto n = static_cast<int>(from.size());
  const double share = 1.0 / (2 * half + 1);
  dvec3 sum(0.0);
  const auto at = [&](int i) { return dvec3(from[static_cast<std::size_t>(i)]); };
  for (int i = 0; i < std::min(half, n); ++i) sum += at(i);
  for (int i = 0; i < n; ++i) {
    if (i + half < n) sum += at(i + half);
    if (i - half - 1 >= 0) sum -= at(i - half - 1);
    to[static_cast<std::size_t>(i)] = vec3(glm::max(sum * share, dvec3(0.0)));
  }
}

/// One line, all passes.
void blurLine(std::vector<vec3>& line, std::vector<vec3>& other,
              const std::array<int, kPasses>& half) {
  other.resize(line.size());
  for (const int h : half) {
    if (h == 0) continue;
    meanOf(line, other, h);
    line.swap(other);
  }
}

void blur(std::vector<vec3>& pixels, int width, int height, double deviation) {
  const auto half = halfWidths(deviation);
  const auto w = static_cast<std::size_t>(width);
  const auto h = static_cast<std::size_t>(height);
  parallelFor(h, 16, [&](std::size_t begin, std::size_t end) {
    std::vector<vec3> line(w);
    std::vector<vec3> other;
    for (std::size_t y = begin; y < end; ++y) {
      std::copy_n(&pixels[y * w], w, line.begin());
      blurLine(line, other, half);
      std::copy_n(line.begin(), w, &pixels[y * w]);
    }
  });
  parallelFor(w, 16, [&](std::size_t begin, std::size_t end) {
    std::vector<vec3> line(h);
    std::vector<vec3> other;
    for (std::size_t x = begin; x < end; ++x) {
      for (std::size_t y = 0; y < h; ++y) line[y] = pixels[y * w + x];
      blurLine(line, other, half);
      for (std::size_t y = 0; y < h; ++y) pixels[y * w + x] = line[y];
    }
  });
}

bool finite(const vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// B of the formula.
vec3 excess(const vec3& radiance, const Bloom& bloom) {
  if (!finite(radiance)) return vec3(0.0F);
  const float y = color::luminance(radiance);
  if (!(static_cast<double>(y) > bloom.threshold)) return vec3(0.0F);
  return radiance * (1.0F - static_cast<float>(bloom.threshold) / y);
}

}  // namespace

std::vector<vec3> spreadLight(std::span<const vec3> radiance, int width, int height,
                              const Bloom& bloom) {
  if (!(bloom.threshold > 0.0) || !(bloom.strength > 0.0) || radiance.empty()) return {};
  std::vector<vec3> bright(radiance.size());
  bool any = false;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    bright[i] = excess(radiance[i], bloom);
    any = any || bright[i] != vec3(0.0F);
  }
  if (!any) return {};
  const auto strength = static_cast<float>(std::min(bloom.strength, 1.0));
  std::vector<vec3> sum(radiance.size(), vec3(0.0F));
  for (const Lobe& lobe : kLobes) {
    std::vector<vec3> spread = bright;
    blur(spread, width, height, lobe.deviation * height);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += strength * lobe.share * spread[i];
  }
  return sum;
}

void addBloom(std::span<vec3> radiance, int width, int height, const Bloom& bloom) {
  const std::vector<vec3> spread = spreadLight(radiance, width, height, bloom);
  if (spread.empty()) return;
  const auto strength = static_cast<float>(std::min(bloom.strength, 1.0));
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    if (!finite(radiance[i])) radiance[i] = vec3(0.0F);
    radiance[i] += spread[i] - strength * excess(radiance[i], bloom);
  }
}

}  // namespace soffit::render

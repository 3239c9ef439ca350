// SPDX-License-Identifier: MIT
#include "tests/projects/picture_difference.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

namespace soffit {
namespace {

using Pixels = std::vector<dvec3>;

/// One direction of the smoothing: `step` to the next pixel of a line, `count` pixels a line.
void smoothLines(Pixels& pixels, int lines, int line_step, int count, int step) {
  constexpr std::array<double, 5> kBinomial = {1.0 / 16, 4.0 / 16, 6.0 / 16, 4.0 / 16, 1.0 / 16};
  const Pixels source = pixels;
  for (int line = 0; line < lines; ++line) {
    for (int i = 0; i < count; ++i) {
      dvec3 sum(0.0);
      for (int k = 0; k < 5; ++k) {
        const int from = std::clamp(i + k - 2, 0, count - 1);
        sum += kBinomial[static_cast<std::size_t>(k)] *
               source[static_cast<std::size_t>(line * line_step + from * step)];
      }
      pixels[static_cast<std::size_t>(line * line_step + i * step)] = sum;
    }
  }
}

Pixels smoothed(const scene::Image& image) {
  Pixels pixels(static_cast<std::size_t>(image.width * image.height));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i] = {image.pixels[3 * i], image.pixels[3 * i + 1], image.pixels[3 * i + 2]};
  }
  smoothLines(pixels, image.height, image.width, image.width, 1);
  smoothLines(pixels, image.width, 1, image.height, image.width);
  return pixels;
}

/// Linear Rec.709 to L*a*b* with the white of D65 (0.95047, 1, 1.08883).
dvec3 toLab(const dvec3& rgb) {
  const dvec3 xyz(glm::dot(dvec3(0.4124564, 0.3575761, 0.1804375), rgb) / 0.95047,
                  glm::dot(dvec3(0.2126729, 0.7151522, 0.0721750), rgb),
                  glm::dot(dvec3(0.0193339, 0.1191920, 0.9503041), rgb) / 1.08883);
  const auto f = [](double t) {
    constexpr double kKnee = 6.0 / 29.0;
    return t > kKnee * kKnee * kKnee ? std::cbrt(t) : t / (3.0 * kKnee * kKnee) + 4.0 / 29.0;
  };
  const dvec3 v(f(xyz.x), f(xyz.y), f(xyz.z));
  return {116.0 * v.y - 16.0, 500.0 * (v.x - v.y), 200.0 * (v.y - v.z)};
}

/// The value that a share of the numbers does not exceed.
double quantile(std::vector<double> values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

PictureDifference pictureDifference(const scene::Image& shown, const scene::Image& stored) {
  assert(shown.width == stored.width && shown.height == stored.height);
  const Pixels a = smoothed(shown);
  const Pixels b = smoothed(stored);
  std::vector<double> delta(a.size());
  std::vector<double> lightness(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const dvec3 d = toLab(a[i]) - toLab(b[i]);
    delta[i] = glm::length(d);
    lightness[i] = d.x;
  }
  PictureDifference difference;
  difference.mean =
      std::accumulate(delta.begin(), delta.end(), 0.0) / static_cast<double>(a.size());
  difference.p95 = quantile(delta, 0.95);
  difference.p99 = quantile(delta, 0.99);
  difference.lightness = quantile(lightness, 0.5);
  return difference;
}

}  // namespace soffit

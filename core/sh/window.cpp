// SPDX-License-Identifier: MIT
#include "core/sh/window.h"

#include "core/sh/basis.h"
#include "core/sh/convolution.h"
#include "core/sh/sphere_samples.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace soffit::sh {
namespace {

template <class Factor>
std::vector<double> windowOf(int bands, const Factor& factor) {
  assert(bands >= 1 && bands <= kMaxBands);
  std::vector<double> window(static_cast<std::size_t>(bands));
  for (int l = 0; l < bands; ++l) window[static_cast<std::size_t>(l)] = factor(double(l));
  return window;
}

/// The function and its slope on the sphere at d.
struct Slope {
  double value = 0.0;
  dvec3 tangent{0.0};
};

Slope slopeAt(std::span<const double> coefficients, int bands, const dvec3& d) {
  std::array<double, kMaxCoefficients> values;
  std::array<dvec3, kMaxCoefficients> gradients;
  evaluateWithGradient(d, bands, values, gradients);
  Slope slope;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    slope.value += coefficients[i] * values[i];
    slope.tangent += coefficients[i] * gradients[i];
  }
  slope.tangent -= glm::dot(slope.tangent, d) * d;
  return slope;
}

/// Steps against the slope, halved where they do not go down, longer where they do.
SphereMinimum rollDown(std::span<const double> coefficients, int bands, dvec3 d) {
  Slope here = slopeAt(coefficients, bands, d);
  double angle = 0.3 / bands;  // length of the next step, radians
  for (int step = 0; step < 200 && angle > 1e-7; ++step) {
    const double steep = glm::length(here.tangent);
    if (steep <= 0.0) break;
    const dvec3 next = glm::normalize(d - std::tan(angle) / steep * here.tangent);
    const Slope there = slopeAt(coefficients, bands, next);
    if (there.value < here.value) {
      d = next;
      here = there;
      angle = std::min(1.5 * angle, 0.3 / bands);
    } else {
      angle *= 0.5;
    }
  }
  return {d, here.value};
}

}  // namespace

std::vector<double> hannWindow(int bands) {
  return windowOf(bands, [=](double l) { return 0.5 * (1.0 + std::cos(kPi * l / bands)); });
}

std::vector<double> lanczosWindow(int bands) {
  return windowOf(bands, [=](double l) {
    const double x = kPi * l / bands;
    return x > 0.0 ? std::sin(x) / x : 1.0;
  });
}

std::vector<double> laplacianWindow(double lambda, int bands) {
  return windowOf(bands, [=](double l) {
    return l > 0.0 ? 1.0 / (1.0 + lambda * l * l * (l + 1.0) * (l + 1.0)) : 1.0;
  });
}

SphereMinimum minimumOf(std::span<const double> coefficients) {
  const int bands = bandsOf(coefficients.size());
  const SphereSamples samples = hammersleySamples(std::max(256, 24 * bands * bands));
  std::vector<double> values(samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    values[k] = reconstruct(coefficients, samples.directions[k]);
  }
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return values[a] != values[b] ? values[a] < values[b] : a < b;
  });
  // One start per valley: two that are less than half a wave, pi / degree, apart share theirs.
  constexpr std::size_t kStarts = 24;
  const double near = std::cos(std::min(kPi / bands, 0.5 * kPi));
  std::vector<dvec3> starts;
  SphereMinimum least{samples.directions[order[0]], values[order[0]]};
  for (const std::size_t k : order) {
    const dvec3& start = samples.directions[k];
    const auto isNear = [&](const dvec3& other) { return glm::dot(start, other) > near; };
    if (std::any_of(starts.begin(), starts.end(), isNear)) continue;
    starts.push_back(start);
    const SphereMinimum found = rollDown(coefficients, bands, start);
    if (found.value < least.value) least = found;
    if (starts.size() == kStarts) break;
  }
  return least;
}

Deringed minimalLaplacian(std::span<const double> coefficients) {
  const int bands = bandsOf(coefficients.size());
  Deringed result{0.0, Coefficients(coefficients.begin(), coefficients.end())};
  const auto nonNegative = [](std::span<const double> c) { return minimumOf(c).value >= 0.0; };
  if (nonNegative(result.coefficients)) return result;
  const auto at = [&](double lambda) {
    return convolve(coefficients, laplacianWindow(lambda, bands));
  };
  double low = 0.0, high = 1.0 / 1024.0;
  while (high < 1e9 && !nonNegative(at(high))) {
    low = high;
    high *= 4.0;
  }
  if (high >= 1e9) {
    std::fill(result.coefficients.begin() + 1, result.coefficients.end(), 0.0);
    result.lambda = std::numeric_limits<double>::infinity();
    return result;
  }
  while (high - low > 1e-3 * high) {
    const double middle = 0.5 * (low + high);
    (nonNegative(at(middle)) ? high : low) = middle;
  }
  result.lambda = high;
  result.coefficients = at(high);
  return result;
}

}  // namespace soffit::sh

// SPDX-License-Identifier: MIT
#include "core/sh/sphere_samples.h"

#include "core/math/quadrature.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::sh {
namespace {

/// The point of the sphere at height z and azimuth 2 pi v.
dvec3 atHeight(double z, double v) {
  const double r = std::sqrt(std::max(0.0, (1.0 - z) * (1.0 + z)));
  const double phi = 2.0 * kPi * v;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

/// cos theta = 1 - 2u is what theta = 2 acos sqrt(1 - u) comes to.
dvec3 fromSquare(double u, double v) {
  return atHeight(1.0 - 2.0 * u, v);
}

SphereSamples equallyWeighted(std::size_t n) {
  SphereSamples samples;
  samples.directions.reserve(n);
  samples.weights.assign(n, 4.0 * kPi / static_cast<double>(n));
  return samples;
}

}  // namespace

SphereSamples randomSamples(int n, std::uint64_t seed) {
  assert(n >= 1);
  SphereSamples samples = equallyWeighted(static_cast<std::size_t>(n));
  Rng rng(seed);
  for (int i = 0; i < n; ++i) {
    const double u = rng.uniformDouble();
    samples.directions.push_back(fromSquare(u, rng.uniformDouble()));
  }
  return samples;
}

SphereSamples stratifiedSamples(int side, std::uint64_t seed) {
  assert(side >= 1);
  SphereSamples samples = equallyWeighted(static_cast<std::size_t>(side) * side);
  Rng rng(seed);
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const double u = (i + rng.uniformDouble()) / side;
      samples.directions.push_back(fromSquare(u, (j + rng.uniformDouble()) / side));
    }
  }
  return samples;
}

SphereSamples hammersleySamples(int n) {
  assert(n >= 1);
  SphereSamples samples = equallyWeighted(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    samples.directions.push_back(
        fromSquare((i + 0.5) / n, radicalInverse2(static_cast<std::uint32_t>(i))));
  }
  return samples;
}

SphereSamples cubature(int degree) {
  assert(degree >= 0);
  const QuadratureRule heights = gaussLegendre(degree / 2 + 1);
  const int azimuths = degree + 1;
  SphereSamples samples;
  for (std::size_t i = 0; i < heights.nodes.size(); ++i) {
    for (int j = 0; j < azimuths; ++j) {
      samples.add(atHeight(heights.nodes[i], (j + 0.5) / azimuths),
                  heights.weights[i] * 2.0 * kPi / azimuths);
    }
  }
  return samples;
}

}  // namespace soffit::sh

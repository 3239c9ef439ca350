// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <vector>

/// Directions over the unit sphere with weights: every way to take an integral over it.
///
/// Each set's weights sum to 4 pi (up to rounding), so that sum w f(d) estimates the integral of f
/// over solid angle, unit [f] sr.
namespace soffit::sh {

struct SphereSamples {
  std::vector<dvec3> directions;  ///< unit
  std::vector<double> weights;    ///< steradians; as many as directions

  [[nodiscard]] std::size_t size() const { return directions.size(); }
  void add(const dvec3& direction, double weight) {
    directions.push_back(direction);
    weights.push_back(weight);
  }
};

/// The tutorial's default number of samples is 100 x 100.
inline constexpr int kTutorialSide = 100;

/// n independent uniform directions: the plain Monte Carlo that the others are measured by;
/// standard error sigma / sqrt(n). n >= 1.
SphereSamples randomSamples(int n, std::uint64_t seed);

/// side x side jittered directions, theta = 2 acos sqrt(1 - x), phi = 2 pi y, of the cells of the
/// unit square (Green 2003; the tutorial). For a function that is smooth over the cells the
/// standard error falls as 1/n, not 1/sqrt(n), n = side^2. Bit-repeatable for a seed. side >= 1.
SphereSamples stratifiedSamples(int side, std::uint64_t seed);

/// n directions of the Hammersley set (i + 1/2)/n, radical inverse of i: deterministic.
SphereSamples hammersleySamples(int n);

/// A product rule that integrates every polynomial of `degree` and below exactly (to rounding):
/// Gauss-Legendre in cos theta times equally spaced phi (Atkinson & Han 2012, section 5.2).
/// ceil((degree+1)/2) * (degree+1) directions; degree >= 0. Products of two functions of n bands
/// need degree 2(n-1), of three 3(n-1).
SphereSamples cubature(int degree);

}  // namespace soffit::sh

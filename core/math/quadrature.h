// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

/// Gauss-Legendre quadrature.
namespace soffit {

struct QuadratureRule {
  std::vector<double> nodes;    ///< ascending
  std::vector<double> weights;  ///< positive
};

/// The n-point Gauss-Legendre rule on [-1, 1], n >= 1: exact for polynomials of degree 2n - 1,
/// nodes to 2e-16 and weights to 1e-14 up to n = 1000. Newton's method on P_n from Tricomi's
/// estimate of its zeros (Press et al., Numerical Recipes, 4.6).
QuadratureRule gaussLegendre(int n);

/// The same on [a, b].
QuadratureRule gaussLegendre(int n, double a, double b);

}  // namespace soffit

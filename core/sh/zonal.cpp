// SPDX-License-Identifier: MIT
#include "core/sh/zonal.h"

#include "core/math/quadrature.h"
#include "core/sh/basis.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::sh {
namespace {

std::size_t sizeOf(int bands) {
  assert(bands >= 1 && bands <= kMaxBands);
  return static_cast<std::size_t>(bands);
}

/// sqrt(4 pi / (2l + 1)).
double zonalScale(std::size_t l) {
  return std::sqrt(4.0 * kPi / (2.0 * static_cast<double>(l) + 1.0));
}

/// integral over u in [0, 1] of P_l(argument(mu)), where mu is the cosine whose share u of the GGX
/// density D mu lies nearer the axis. With u = 1 - w^2: mu = w / sqrt(w^2 + alpha^2 (1 - w^2)),
/// which turns within w ~ alpha: pieces that double from there.
template <class Argument>
Kernel ggxKernel(double alpha, int bands, const Argument& argument) {
  assert(alpha > 0.0 && alpha <= 1.0);
  static const QuadratureRule rule = gaussLegendre(24);
  Kernel kernel(sizeOf(bands), 0.0);
  double begin = 0.0;
  double end = std::min(1.0, 0.5 * alpha);
  while (begin < 1.0) {
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double w = begin + 0.5 * (end - begin) * (rule.nodes[i] + 1.0);
      const double mu = w / std::sqrt(w * w + alpha * alpha * (1.0 - w) * (1.0 + w));
      const std::vector<double> p = legendreValues(argument(mu), bands);
      const double weight = 0.5 * (end - begin) * rule.weights[i] * 2.0 * w;
      for (std::size_t l = 0; l < kernel.size(); ++l) kernel[l] += weight * p[l];
    }
    begin = end;
    end = std::min(1.0, 2.0 * end);
  }
  return kernel;
}

}  // namespace

std::vector<double> legendreValues(double t, int bands) {
  std::vector<double> p(sizeOf(bands));
  p[0] = 1.0;
  if (p.size() > 1) p[1] = t;
  for (std::size_t l = 2; l < p.size(); ++l) {
    const auto n = static_cast<double>(l);
    p[l] = ((2.0 * n - 1.0) * t * p[l - 1] - (n - 1.0) * p[l - 2]) / n;
  }
  return p;
}

std::vector<double> legendreSlopes(double t, int bands) {
  const std::vector<double> p = legendreValues(t, bands);
  std::vector<double> slope(p.size(), 0.0);
  if (p.size() > 1) slope[1] = 1.0;
  for (std::size_t l = 2; l < p.size(); ++l) {
    slope[l] = (2.0 * static_cast<double>(l) - 1.0) * p[l - 1] + slope[l - 2];
  }
  return slope;
}

std::vector<double> projectZonal(const std::function<double(double)>& f,
                                 const ZonalOptions& options) {
  std::vector<double> ends{-1.0, 1.0};
  for (const double t : options.breakpoints) {
    if (t > -1.0 && t < 1.0) ends.push_back(t);
  }
  std::sort(ends.begin(), ends.end());
  Kernel kernel(sizeOf(options.bands), 0.0);
  for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece) {
    const QuadratureRule rule = gaussLegendre(options.nodes, ends[piece], ends[piece + 1]);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const std::vector<double> p = legendreValues(rule.nodes[i], options.bands);
      const double value = 2.0 * kPi * rule.weights[i] * f(rule.nodes[i]);
      for (std::size_t l = 0; l < kernel.size(); ++l) kernel[l] += value * p[l];
    }
  }
  return zonalFromKernel(kernel);
}

Kernel kernelFromZonal(std::span<const double> zonal) {
  Kernel kernel(zonal.begin(), zonal.end());
  for (std::size_t l = 0; l < kernel.size(); ++l) kernel[l] *= zonalScale(l);
  return kernel;
}

std::vector<double> zonalFromKernel(std::span<const double> kernel) {
  std::vector<double> zonal(kernel.begin(), kernel.end());
  for (std::size_t l = 0; l < zonal.size(); ++l) zonal[l] /= zonalScale(l);
  return zonal;
}

Coefficients zonalAbout(std::span<const double> kernel, const dvec3& axis) {
  const int bands = static_cast<int>(kernel.size());
  Coefficients c(coefficientCount(bands));
  evaluate(axis, bands, c);
  for (std::size_t i = 0; i < c.size(); ++i) c[i] *= kernel[static_cast<std::size_t>(degreeOf(i))];
  return c;
}

Kernel clampedCosineKernel(int bands) {
  Kernel kernel(sizeOf(bands), 0.0);
  double a = kPi / 4.0;
  for (std::size_t l = 0; l < kernel.size(); ++l) {
    if (l == 0) kernel[l] = kPi;
    if (l == 1) kernel[l] = 2.0 * kPi / 3.0;
    if (l < 2 || l % 2 == 1) continue;
    kernel[l] = a;
    const auto n = static_cast<double>(l);
    a *= -(n - 1.0) / (n + 4.0);
  }
  return kernel;
}

Kernel phongKernel(double exponent, int bands) {
  assert(exponent >= 0.0);
  Kernel kernel(sizeOf(bands), 1.0);
  for (std::size_t l = 1; l < kernel.size(); ++l) {
    const auto n = static_cast<double>(l);
    kernel[l] = l == 1 ? (exponent + 1.0) / (exponent + 2.0)
                       : kernel[l - 2] * (exponent - n + 2.0) / (exponent + n + 1.0);
  }
  return kernel;
}

Kernel vonMisesFisherKernel(double kappa, int bands) {
  assert(kappa >= 0.0);
  Kernel kernel(sizeOf(bands), 0.0);
  kernel[0] = 1.0;
  if (kappa == 0.0) return kernel;
  // ratio_l = i_{l+1} / i_l = 1 / (ratio_{l+1} + (2l + 3) / kappa), from far above down; an error
  // in the start shrinks by ratio^2 a step, so the way grows with kappa.
  std::vector<double> ratio(kernel.size());
  double r = 0.0;
  for (int l = bands + 40 + static_cast<int>(std::min(4.0 * kappa, 1e6)); l >= 0; --l) {
    r = 1.0 / (r + (2.0 * l + 3.0) / kappa);
    if (l < bands) ratio[static_cast<std::size_t>(l)] = r;
  }
  for (std::size_t l = 1; l < kernel.size(); ++l) kernel[l] = kernel[l - 1] * ratio[l - 1];
  return kernel;
}

Kernel vonMisesFisherApproximation(double kappa, int bands) {
  assert(kappa > 0.0);
  Kernel kernel(sizeOf(bands));
  for (std::size_t l = 0; l < kernel.size(); ++l) {
    const auto n = static_cast<double>(l);
    kernel[l] = std::exp(-n * (n + 1.0) / (2.0 * kappa));
  }
  return kernel;
}

Kernel ggxHalfVectorKernel(double alpha, int bands) {
  return ggxKernel(alpha, bands, [](double mu) { return mu; });
}

Kernel ggxReflectedKernel(double alpha, int bands) {
  return ggxKernel(alpha, bands, [](double mu) { return 2.0 * mu * mu - 1.0; });
}

Kernel capKernel(double sin_radius, int bands) {
  assert(sin_radius >= 0.0 && sin_radius <= 1.0);
  const double c = std::sqrt((1.0 - sin_radius) * (1.0 + sin_radius));
  Kernel kernel = legendreSlopes(c, bands);
  const double base = 2.0 * kPi * sin_radius * sin_radius;
  for (std::size_t l = 1; l < kernel.size(); ++l) {
    const auto n = static_cast<double>(l);
    kernel[l] *= base / (n * (n + 1.0));
  }
  kernel[0] = base / (1.0 + c);
  return kernel;
}

}  // namespace soffit::sh

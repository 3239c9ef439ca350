// SPDX-License-Identifier: MIT
#include "core/glossy/bands.h"

#include "core/math/quadrature.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace soffit::glossy {
namespace {

/// The kernel of sh::ggxReflectedKernel() for degrees beyond sh::kMaxBands: the same substitution,
/// with nodes enough for P_400.
std::vector<double> longKernel(double alpha, std::size_t degrees) {
  static const QuadratureRule rule = gaussLegendre(256);
  std::vector<double> kernel(degrees, 0.0);
  double begin = 0.0;
  double end = std::min(1.0, 0.5 * alpha);
  while (begin < 1.0) {
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double w = begin + 0.5 * (end - begin) * (rule.nodes[i] + 1.0);
      const double mu = w / std::sqrt(w * w + alpha * alpha * (1.0 - w) * (1.0 + w));
      const double t = 2.0 * mu * mu - 1.0;
      const double weight = 0.5 * (end - begin) * rule.weights[i] * 2.0 * w;
      double before = 1.0;
      double p = t;
      kernel[0] += weight;
      for (std::size_t l = 1; l < degrees; ++l) {
        kernel[l] += weight * p;
        const auto n = static_cast<double>(l);
        const double next = ((2.0 * n + 1.0) * t * p - n * before) / (n + 1.0);
        before = p;
        p = next;
      }
    }
    begin = end;
    end = std::min(1.0, 2.0 * end);
  }
  return kernel;
}

double lastKernel(double alpha, int bands) {
  return sh::ggxReflectedKernel(alpha, bands).back();
}

}  // namespace

std::optional<int> bandsFor(double alpha) {
  for (int bands = 3; bands <= sh::kMaxBands; ++bands) {
    if (lastKernel(alpha, bands) <= kServedKernel) return bands;
  }
  return std::nullopt;
}

double leastAlphaFor(int bands) {
  assert(bands >= 3 && bands <= sh::kMaxBands);
  double low = 1.0e-3;  // the kernel falls as alpha grows
  double high = 1.0;
  while (high - low > 1.0e-6) {
    const double middle = 0.5 * (low + high);
    (lastKernel(middle, bands) <= kServedKernel ? high : low) = middle;
  }
  return high;
}

double pointLightError(double alpha, int bands) {
  const double a2 = alpha * alpha;
  const double whole = (1.0 + a2 + a2 * a2) / (12.0 * kPi * a2);
  const sh::Kernel kernel = sh::ggxReflectedKernel(alpha, bands);
  double kept = 0.0;
  for (std::size_t l = 0; l < kernel.size(); ++l) {
    kept += (2.0 * static_cast<double>(l) + 1.0) / (4.0 * kPi) * kernel[l] * kernel[l];
  }
  return std::sqrt(std::max(0.0, 1.0 - kept / whole));
}

double edgeError(double alpha, int bands) {
  constexpr std::size_t kDegrees = 400;
  const std::vector<double> kernel = longKernel(alpha, kDegrees);
  // Half a sphere: 2 pi integral over [0, 1] of P_l = 2 pi (P_{l-1}(0) - P_{l+1}(0)) / (2l + 1).
  std::vector<double> at_zero(kDegrees + 1, 0.0);
  at_zero[0] = 1.0;
  for (std::size_t l = 2; l <= kDegrees; ++l) {
    at_zero[l] = -at_zero[l - 2] * (static_cast<double>(l) - 1.0) / static_cast<double>(l);
  }
  double lost = 0.0;
  for (auto l = static_cast<std::size_t>(bands); l < kDegrees; ++l) {
    const double width = 2.0 * static_cast<double>(l) + 1.0;
    const double half = 2.0 * kPi * (at_zero[l - 1] - at_zero[l + 1]) / width;
    lost += width / (4.0 * kPi) * half * half * kernel[l] * kernel[l];
  }
  return std::sqrt(lost / (4.0 * kPi));
}

double phongExponentFor(double alpha) {
  const double mean_cosine = sh::ggxReflectedKernel(alpha, 2)[1];
  return mean_cosine > 0.5 ? (2.0 * mean_cosine - 1.0) / (1.0 - mean_cosine) : 0.0;
}

}  // namespace soffit::glossy

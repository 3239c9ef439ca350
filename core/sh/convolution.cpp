// SPDX-License-Identifier: MIT
#include "core/sh/convolution.h"

#include "core/sh/basis.h"

#include <cassert>

namespace soffit::sh {

Coefficients convolve(std::span<const double> coefficients, std::span<const double> kernel) {
  assert(coefficients.size() == kernel.size() * kernel.size());
  Coefficients out(coefficients.begin(), coefficients.end());
  std::size_t i = 0;
  for (std::size_t l = 0; l < kernel.size(); ++l) {
    for (; i < (l + 1) * (l + 1); ++i) out[i] *= kernel[l];
  }
  return out;
}

double irradiance(std::span<const double> radiance, const dvec3& n) {
  return reconstruct(convolve(radiance, clampedCosineKernel(bandsOf(radiance.size()))), n);
}

}  // namespace soffit::sh

// SPDX-License-Identifier: MIT
#include "core/sh/sphere_light.h"

#include "core/sh/basis.h"
#include "core/sh/zonal.h"

#include <array>
#include <cmath>

namespace soffit::sh {

Coefficients sphereCoefficients(const dvec3& center, double radius, const dvec3& p, int bands) {
  const dvec3 to = center - p;
  const double distance = glm::length(to);
  if (!(radius > 0.0) || !(distance > radius)) return Coefficients(coefficientCount(bands), 0.0);
  return zonalAbout(capKernel(radius / distance, bands), to / distance);
}

CoefficientsWithGradient sphereCoefficientsWithGradient(const dvec3& center, double radius,
                                                        const dvec3& p, int bands) {
  const std::size_t count = coefficientCount(bands);
  CoefficientsWithGradient result{Coefficients(count, 0.0), std::vector<dvec3>(count, dvec3(0.0))};
  const dvec3 to = center - p;
  const double distance = glm::length(to);
  if (!(radius > 0.0) || !(distance > radius)) return result;
  const dvec3 axis = to / distance;
  const double sine = radius / distance;
  const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
  const Kernel kernel = capKernel(sine, bands);
  const std::vector<double> legendre = legendreValues(cosine, bands);
  std::array<double, kMaxCoefficients> basis;
  std::array<dvec3, kMaxCoefficients> slope;
  evaluateWithGradient(axis, bands, basis, slope);
  for (std::size_t i = 0; i < count; ++i) {
    const auto l = static_cast<std::size_t>(degreeOf(i));
    // The cap shrinks: dk/dc = -2 pi P_l(c), dc/dr = sin^2 / (r c), and r grows against the axis.
    const double shrink = 2.0 * kPi * legendre[l] * sine * sine / (distance * cosine);
    // It also turns: d axis = -(dp - axis (axis . dp)) / r.
    const dvec3 tangent = slope[i] - glm::dot(slope[i], axis) * axis;
    result.values[i] = kernel[l] * basis[i];
    result.gradients[i] = shrink * basis[i] * axis - kernel[l] / distance * tangent;
  }
  return result;
}

}  // namespace soffit::sh

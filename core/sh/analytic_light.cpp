// SPDX-License-Identifier: MIT
#include "core/sh/analytic_light.h"

#include "core/sh/zonal.h"

#include <algorithm>
#include <cmath>

namespace soffit::sh {
namespace {

dvec3 sideAxis(const AnalyticLight& light) {
  return {std::cos(light.side_azimuth), std::sin(light.side_azimuth), 0.0};
}

void addPatch(double gain, double threshold, const dvec3& axis, int bands, Coefficients& sum) {
  ZonalOptions options{.bands = bands, .breakpoints = {}};
  if (gain != 0.0) options.breakpoints.push_back(threshold / gain);
  const auto zonal =
      projectZonal([=](double t) { return std::max(0.0, gain * t - threshold); }, options);
  const Coefficients patch = zonalAbout(kernelFromZonal(zonal), axis);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += patch[i];
}

}  // namespace

double AnalyticLight::operator()(const dvec3& d) const {
  const double overhead = std::max(0.0, overhead_gain * d.z - overhead_threshold);
  const double side = std::max(0.0, side_gain * glm::dot(d, sideAxis(*this)) - side_threshold);
  return scale * (overhead + side);
}

Coefficients analyticCoefficients(const AnalyticLight& light, int bands) {
  Coefficients sum(coefficientCount(bands), 0.0);
  addPatch(light.overhead_gain, light.overhead_threshold, dvec3(0, 0, 1), bands, sum);
  addPatch(light.side_gain, light.side_threshold, sideAxis(light), bands, sum);
  for (double& c : sum) c *= light.scale;
  return sum;
}

}  // namespace soffit::sh

// SPDX-License-Identifier: MIT
#include "core/daylight/cie_sky.h"

#include "core/math/quadrature.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace soffit::daylight {
namespace {

constexpr int kOvercast = 16;
constexpr int kSteps = 4096;  // of the quick tables

double gradation(const CieParameters& p, double cos_zenith) {
  // exp(b / 0) with b < 0 is 0: the limit at the horizon.
  return cos_zenith > 0.0 ? 1.0 + p.a * std::exp(p.b / cos_zenith) : 1.0;
}

double indicatrix(const CieParameters& p, double cos_chi) {
  const double chi = std::acos(std::clamp(cos_chi, -1.0, 1.0));
  return 1.0 + p.c * (std::exp(p.d * chi) - std::exp(p.d * 0.5 * kPi)) + p.e * cos_chi * cos_chi;
}

/// The relative luminance's share of the horizontal illuminance: integral of L/L_z cos Z.
double horizontalIntegral(const CieSky& sky) {
  // In the azimuth the integrand is periodic; the sun's cusp alone limits the rule: 1e-7 here.
  constexpr int kZenith = 192;
  constexpr int kAzimuth = 384;
  const QuadratureRule rule = gaussLegendre(kZenith, 0.0, 1.0);
  double sum = 0.0;
  for (int i = 0; i < kZenith; ++i) {
    const double z = rule.nodes[static_cast<std::size_t>(i)];
    const double r = std::sqrt(1.0 - z * z);
    double ring = 0.0;
    for (int j = 0; j < kAzimuth; ++j) {
      const double phi = 2.0 * kPi * (j + 0.5) / kAzimuth;
      ring += sky.relative({r * std::cos(phi), r * std::sin(phi), z});
    }
    sum += rule.weights[static_cast<std::size_t>(i)] * z * ring * (2.0 * kPi / kAzimuth);
  }
  return sum;
}

}  // namespace

CieParameters cieParameters(int type) {
  static constexpr std::array<CieParameters, 15> kTypes{{
      {4.0, -0.70, 0.0, -1.0, 0.00},    // 1 overcast, steep gradation
      {4.0, -0.70, 2.0, -1.5, 0.15},    // 2 overcast, brighter toward the sun
      {1.1, -0.80, 0.0, -1.0, 0.00},    // 3 overcast, moderate gradation
      {1.1, -0.80, 2.0, -1.5, 0.15},    // 4
      {0.0, -1.00, 0.0, -1.0, 0.00},    // 5 uniform
      {0.0, -1.00, 2.0, -1.5, 0.15},    // 6 partly cloudy
      {0.0, -1.00, 5.0, -2.5, 0.30},    // 7
      {0.0, -1.00, 10.0, -3.0, 0.45},   // 8
      {-1.0, -0.55, 2.0, -1.5, 0.15},   // 9 partly cloudy, obscured sun
      {-1.0, -0.55, 5.0, -2.5, 0.30},   // 10
      {-1.0, -0.55, 10.0, -3.0, 0.45},  // 11 white-blue
      {-1.0, -0.32, 10.0, -3.0, 0.45},  // 12 clear, low turbidity
      {-1.0, -0.32, 16.0, -3.0, 0.30},  // 13 clear, polluted
      {-1.0, -0.15, 16.0, -3.0, 0.30},  // 14 cloudless, broad corona
      {-1.0, -0.15, 24.0, -2.8, 0.15},  // 15 white-blue turbid, broad corona
  }};
  assert(type >= 1 && type <= 15);
  return kTypes[static_cast<std::size_t>(std::clamp(type, 1, 15) - 1)];
}

dvec3 skyDirection(double azimuth, double altitude) {
  return {std::cos(altitude) * std::sin(azimuth), std::cos(altitude) * std::cos(azimuth),
          std::sin(altitude)};
}

CieSky::CieSky(int type, const dvec3& to_sun, double horizontal_illuminance)
    : type_(type), to_sun_(to_sun) {
  if (type_ != kOvercast) {
    p_ = cieParameters(type_);
    at_zenith_ = gradation(p_, 1.0) * indicatrix(p_, to_sun_.z);
  }
  // Type 16 in closed form: integral of (1 + 2 z)/3 z 2 pi dz = 7 pi / 9.
  const double integral = type_ == kOvercast ? 7.0 * kPi / 9.0 : horizontalIntegral(*this);
  zenith_luminance_ = horizontal_illuminance / integral;
  for (int i = 0; i <= kSteps; ++i) {
    const double at = static_cast<double>(i) / kSteps;
    const bool overcast = type_ == kOvercast;
    const double chord = 2.0 * at;
    gradation_.push_back(
        static_cast<float>(overcast ? (1.0 + 2.0 * at) / 3.0 : gradation(p_, at) / at_zenith_));
    indicatrix_.push_back(
        static_cast<float>(overcast ? 1.0 : indicatrix(p_, 1.0 - 0.5 * chord * chord)));
  }
}

double CieSky::quickLuminance(const dvec3& d) const {
  const auto look = [](const std::vector<float>& table, double at) {
    const double x = std::clamp(at, 0.0, 1.0) * kSteps;
    const auto i = std::min(static_cast<std::size_t>(x), std::size_t{kSteps - 1});
    const double f = x - static_cast<double>(i);
    return (1.0 - f) * static_cast<double>(table[i]) + f * static_cast<double>(table[i + 1]);
  };
  const double chord = std::sqrt(std::max(0.0, 2.0 - 2.0 * glm::dot(d, to_sun_)));
  return zenith_luminance_ * look(gradation_, d.z) * look(indicatrix_, 0.5 * chord);
}

double CieSky::relative(const dvec3& d) const {
  if (type_ == kOvercast) return (1.0 + 2.0 * std::max(d.z, 0.0)) / 3.0;
  return gradation(p_, d.z) * indicatrix(p_, glm::dot(d, to_sun_)) / at_zenith_;
}

}  // namespace soffit::daylight

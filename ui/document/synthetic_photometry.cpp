// SPDX-License-Identifier: MIT
#include "ui/document/synthetic_photometry.h"

#include "core/math/vec.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kGammaStepDeg = 2.5;
constexpr double kPlaneStepDeg = 15.0;
constexpr double kWasherTiltDeg = 35.0;
constexpr double kWasherBeamDeg = 60.0;

/// The power of the cosine that is one half at `half_deg`.
double powerOf(double half_deg) {
  return std::log(0.5) / std::log(std::cos(radians(half_deg)));
}

io::PhotometricFile finished(photometry::IntensityDistribution distribution,
                             const std::string& name, double lumens) {
  distribution.name = name;
  const double factor = lumens / distribution.flux();
  // Whole hundredths: the file stays short.
  for (double& cd : distribution.candela) cd = std::round(100.0 * factor * cd) / 100.0;
  io::PhotometricFile file;
  file.format = "IES LM-63-2019";
  file.lumens = distribution.flux();
  file.absolute = true;
  file.keywords = {{"TEST", "synthetic"}, {"MANUFAC", "Soffit"}, {"LUMINAIRE", name}};
  file.n_vertical = static_cast<int>(distribution.gamma_deg.size());
  file.n_horizontal = static_cast<int>(distribution.c_deg.size());
  file.distribution = std::move(distribution);
  return file;
}

}  // namespace

io::PhotometricFile syntheticSpot(const std::string& name, double beam_deg, double lumens) {
  photometry::IntensityDistribution d;
  d.c_deg = {0.0};
  const double power = powerOf(0.5 * beam_deg);
  // Steps as fine as the beam needs.
  const double step = std::min(kGammaStepDeg, beam_deg / 16.0);
  const int count = static_cast<int>(std::ceil(90.0 / step));
  for (int i = 0; i <= count; ++i) {
    const double gamma = 90.0 * i / count;
    d.gamma_deg.push_back(gamma);
    d.candela.push_back(i == count ? 0.0 : std::pow(std::cos(radians(gamma)), power));
  }
  return finished(std::move(d), name, lumens);
}

io::PhotometricFile syntheticWallWasher(const std::string& name, double lumens) {
  photometry::IntensityDistribution d;
  const double power = powerOf(0.5 * kWasherBeamDeg);
  const dvec3 toward(std::sin(radians(kWasherTiltDeg)), 0.0, -std::cos(radians(kWasherTiltDeg)));
  for (int i = 0; kGammaStepDeg * i <= 90.0; ++i) d.gamma_deg.push_back(kGammaStepDeg * i);
  for (int plane = 0; kPlaneStepDeg * plane < 360.0; ++plane) {
    const double c = kPlaneStepDeg * plane;
    d.c_deg.push_back(c);
    for (const double gamma : d.gamma_deg) {
      const dvec3 w(std::sin(radians(gamma)) * std::cos(radians(c)),
                    std::sin(radians(gamma)) * std::sin(radians(c)), -std::cos(radians(gamma)));
      // It shines downward only: the lobe fades out toward the ceiling.
      const double fade = std::min(1.0, std::cos(radians(gamma)) / 0.2);
      d.candela.push_back(fade * std::pow(std::max(glm::dot(w, toward), 0.0), power));
    }
  }
  return finished(std::move(d), name, lumens);
}

}  // namespace soffit::ui

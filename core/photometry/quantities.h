// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

/// Photometric quantities as types: the type is the quantity, the member is the unit.
///
/// They cross module borders so that cd never lands where lm was meant. Aggregates on purpose:
/// `LuminousIntensity{.cd = 100.0}` says what it is and costs nothing.
namespace soffit::photometry {

struct LuminousFlux {
  double lm = 0.0;
};
struct LuminousIntensity {
  double cd = 0.0;
};
struct Illuminance {
  double lx = 0.0;
};
struct Luminance {
  double cd_per_m2 = 0.0;
};
struct SolidAngle {
  double sr = 0.0;
};

/// Illuminance from a point source: E = I cos / d².
///
/// distance       m, > 0.
/// cos_incidence  cosine between the receiver's normal and the direction to the source;
///                negative means behind, which receives 0.
constexpr Illuminance pointIlluminance(LuminousIntensity intensity, double distance,
                                       double cos_incidence) {
  return {.lx = intensity.cd * std::max(cos_incidence, 0.0) / (distance * distance)};
}

}  // namespace soffit::photometry

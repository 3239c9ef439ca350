// SPDX-License-Identifier: MIT
#include "core/photometry/beam.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace soffit::photometry {
namespace {

/// A corner of the polar curve: signed degrees from the axis, candela. Two corners at one angle
/// are a jump (the end of the table).
struct Corner {
  double angle;
  double cd;
};
using Profile = std::vector<Corner>;

constexpr double kHorizonDeg = 90.0;

/// The half-plane at C as a curve over 0..180 degrees from the axis, ascending.
Profile halfPlane(const IntensityDistribution& d, double c_deg, bool up) {
  Profile half;
  for (const double gamma : d.gamma_deg) {
    half.push_back({up ? 180.0 - gamma : gamma, d.intensityAt(c_deg, gamma)});
  }
  if (up) std::reverse(half.begin(), half.end());
  // Outside its range the table is dark: drop to 0 where it starts or ends inside 0..180.
  if (half.front().angle > 0.0) half.insert(half.begin(), {{0.0, 0.0}, {half.front().angle, 0.0}});
  if (half.back().angle < 180.0) {
    half.push_back({half.back().angle, 0.0});
    half.push_back({180.0, 0.0});
  }
  return half;
}

/// The whole plane over -180..180, C on the positive side.
Profile wholePlane(const IntensityDistribution& d, double c_deg, bool up) {
  Profile profile = halfPlane(d, c_deg + 180.0, up);
  std::reverse(profile.begin(), profile.end());
  for (Corner& corner : profile) corner.angle = -corner.angle;
  const Profile right = halfPlane(d, c_deg, up);
  profile.insert(profile.end(), right.begin(), right.end());
  return profile;
}

double planePeakGamma(const IntensityDistribution& d, double c_deg) {
  double best = -1.0;
  double at = 0.0;
  for (const double gamma : d.gamma_deg) {
    const double cd = std::max(d.intensityAt(c_deg, gamma), d.intensityAt(c_deg + 180.0, gamma));
    if (cd > best) {
      best = cd;
      at = gamma;
    }
  }
  return at;
}

/// The greatest angle of a - b with at least `threshold`, if any.
std::optional<double> lastBright(const Corner& a, const Corner& b, double threshold) {
  if (b.cd >= threshold) return b.angle;
  if (a.cd < threshold) return std::nullopt;
  const double t = (a.cd - threshold) / (a.cd - b.cd);
  return a.angle + t * (b.angle - a.angle);
}

/// Part of a - b up to the horizon; a.angle is at most that.
Corner cutAtHorizon(const Corner& a, const Corner& b) {
  if (b.angle <= kHorizonDeg) return b;
  const double t = (kHorizonDeg - a.angle) / (b.angle - a.angle);
  return {kHorizonDeg, a.cd + t * (b.cd - a.cd)};
}

/// The outermost bright angle of an ascending profile on its positive side.
std::optional<double> outermost(const Profile& profile, double threshold) {
  std::optional<double> edge;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const Corner& a = profile[i];
    const Corner& b = profile[i + 1];
    if (b.angle < -kHorizonDeg) continue;
    if (a.angle <= kHorizonDeg) {
      const auto bright = lastBright(a, cutAtHorizon(a, b), threshold);
      if (bright && *bright >= -kHorizonDeg) edge = bright;
    }
    if (b.angle <= kHorizonDeg) continue;
    // Past the horizon the light is followed only as long as it never fell below the threshold.
    if (!edge || *edge < std::max(a.angle, kHorizonDeg)) return edge;
    const auto bright = lastBright(a, b, threshold);
    edge = std::max(*edge, bright.value_or(*edge));
    if (*edge < b.angle) return edge;
  }
  return edge;
}

Profile mirrored(Profile profile) {
  std::reverse(profile.begin(), profile.end());
  for (Corner& corner : profile) corner.angle = -corner.angle;
  return profile;
}

PrincipalAngles principal(const IntensityDistribution& d, double share, BeamReference reference) {
  return {beamAngleDeg(d, 0.0, share, reference), beamAngleDeg(d, 90.0, share, reference)};
}

}  // namespace

double beamAngleDeg(const IntensityDistribution& distribution, double c_deg, double share,
                    BeamReference reference) {
  if (distribution.gamma_deg.size() < 2 || distribution.c_deg.empty()) return 0.0;
  const double peak_gamma = planePeakGamma(distribution, c_deg);
  const bool up = peak_gamma > kHorizonDeg;
  const double peak = std::max(distribution.intensityAt(c_deg, peak_gamma),
                               distribution.intensityAt(c_deg + 180.0, peak_gamma));
  const double axis = up ? 180.0 : 0.0;
  const double centre =
      (distribution.intensityAt(c_deg, axis) + distribution.intensityAt(c_deg + 180.0, axis)) / 2.0;
  const double full = reference == BeamReference::peak ? peak : centre;
  if (!(full > 0.0)) return 0.0;
  const Profile profile = wholePlane(distribution, c_deg, up);
  const auto right = outermost(profile, share * full);
  const auto left = outermost(mirrored(profile), share * full);
  return right && left ? std::clamp(*right + *left, 0.0, 360.0) : 0.0;
}

PrincipalAngles beamAngles(const IntensityDistribution& distribution, BeamReference reference) {
  return principal(distribution, kBeamShare, reference);
}

PrincipalAngles fieldAngles(const IntensityDistribution& distribution, BeamReference reference) {
  return principal(distribution, kFieldShare, reference);
}

}  // namespace soffit::photometry

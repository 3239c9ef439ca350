// SPDX-License-Identifier: MIT
#include "core/light/polygon_irradiance.h"

#include "core/math/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::light {
namespace {

/// Nodes and weights of 16-point Gauss-Legendre on [-1, 1], positive half.
constexpr std::array<double, 8> kGaussNode = {0.0950125098376374, 0.2816035507792589, 0.4580167776572274,
                                              0.6178762444026438, 0.7554044083550030, 0.8656312023878318,
                                              0.9445750230732326, 0.9894009349916499};
constexpr std::array<double, 8> kGaussWeight = {0.1894506104550685, 0.1826034150449236, 0.1691565193950025,
                                                0.1495959888165767, 0.1246289712555339, 0.0951585116824928,
                                                0.0622535239386479, 0.0271524594117541};

}  // namespace

void ContourSum::addArc(const dvec3& a, const dvec3& b) {
  const dvec3 cross = glm::cross(a, b);
  const double s = glm::length(cross);
  if (s <= 0.0) return;  // the edge points at the receiver, or a vertex lies on it
  // Half-angle form of atan2(s, a.b): one division, exact for small angles and at 180 degrees.
  const double g = 2.0 * std::atan2(s, glm::length(a) * glm::length(b) + glm::dot(a, b));
  sum_ -= g * glm::dot(n_, cross) / s;
}

void ContourSum::clippedEdge(const dvec3& a, double ha, const dvec3& b, double hb) {
  const bool a_in = ha > 0.0;
  const bool b_in = hb > 0.0;
  if (a_in && b_in) {
    addArc(a, b);
    return;
  }
  if (!a_in && !b_in) return;
  const dvec3 crossing = a + (b - a) * (ha / (ha - hb));
  if (a_in) {
    addArc(a, crossing);
    exit_ = crossing;
    has_exit_ = true;
  } else {
    // The piece of the horizon between where the loop left and where it returns.
    if (has_exit_) {
      addArc(exit_, crossing);
    } else {
      entry_ = crossing;
      has_entry_ = true;
    }
    addArc(crossing, b);
    has_exit_ = false;
  }
}

void ContourSum::vertex(const dvec3& v) {
  const double height = glm::dot(n_, v);
  if (started_) {
    clippedEdge(last_, last_height_, v, height);
  } else {
    first_ = v;
    first_height_ = height;
    started_ = true;
  }
  last_ = v;
  last_height_ = height;
}

double ContourSum::value() {
  if (!started_) return 0.0;
  clippedEdge(last_, last_height_, first_, first_height_);
  if (has_exit_ && has_entry_) addArc(exit_, entry_);
  return std::max(0.0, 0.5 * sum_);
}

double polygonIrradiance(std::span<const dvec3> outline, const dvec3& p, const dvec3& n) {
  ContourSum sum(n);
  for (const dvec3& corner : outline) sum.vertex(corner - p);
  return sum.value();
}

namespace {

/// Integrals from psi0 to psi1 over 1, cos and sin divided by s - k cos(psi), k >= 0, s > k. With
/// Y = sin / (s + q - k cos) and q = sqrt(s^2 - k^2), psi/q + 2/q atan(k Y) is continuous, and
/// nothing cancels as k goes to 0.
struct ArcIntegrals {
  double one, cosine, sine;
};

ArcIntegrals arcIntegrals(double s, double k, double psi0, double psi1) {
  const double q = std::sqrt((s - k) * (s + k));
  const auto turn = [&](double psi) {
    const double y = std::sin(psi) / (s + q - k * std::cos(psi));
    return k * std::abs(y) < 1e-8 ? y : std::atan(k * y) / k;
  };
  const double turned = turn(psi1) - turn(psi0);
  const double below = s - k * std::cos(psi0);
  const double x = (std::cos(psi0) - std::cos(psi1)) / below;
  ArcIntegrals i{};
  i.one = (psi1 - psi0 + 2.0 * k * turned) / q;
  i.cosine = (psi1 - psi0) * k / (q * (s + q)) + 2.0 * s / q * turned;
  i.sine = k * std::abs(x) < 1e-8 ? x : std::log1p(k * x) / k;
  return i;
}

/// E/L of the part of a disk above the receiver's horizon, which cuts it: Lambert's contour integral
/// -1/2 n . (r x dr)/r^2 along the arc in closed form, and along the chord. c: from the receiver to
/// the disk's center.
double segmentIrradiance(const dvec3& c, const dvec3& axis, double radius, const dvec3& n) {
  // The arc is centred on the highest point of the rim.
  const dvec3 up = glm::normalize(n - glm::dot(n, axis) * axis);
  const dvec3 side = glm::cross(axis, up);
  const double share = -glm::dot(n, c) / (radius * glm::dot(n, up));
  const double half = std::acos(std::clamp(share, -1.0, 1.0));
  // phi on the rim: r = c + radius (cos phi up + sin phi side); r^2 = s - k cos(phi - phi0).
  const double cu = glm::dot(c, up);
  const double cs = glm::dot(c, side);
  const double s = glm::dot(c, c) + radius * radius;
  const double k = 2.0 * radius * std::hypot(cu, cs);
  const double phi0 = std::atan2(-cs, -cu);
  if (s - k <= 1e-14 * s) return 0.0;  // on the rim itself
  const ArcIntegrals i = arcIntegrals(s, k, -half - phi0, half - phi0);
  // n . (r x r') = radius (n x c) . u' + radius^2 n . axis, u' = -sin phi up + cos phi side.
  const dvec3 g = glm::cross(n, c);
  const double gu = glm::dot(g, up);
  const double gs = glm::dot(g, side);
  const double cosine = gs * std::cos(phi0) - gu * std::sin(phi0);
  const double sine = -gs * std::sin(phi0) - gu * std::cos(phi0);
  const double arc = radius * (cosine * i.cosine + sine * i.sine) + radius * radius * glm::dot(n, axis) * i.one;
  const dvec3 last = c + radius * (std::cos(half) * up + std::sin(half) * side);
  const dvec3 first = c + radius * (std::cos(half) * up - std::sin(half) * side);
  const dvec3 cross = glm::cross(last, first);
  const double length = glm::length(cross);
  const double angle = std::atan2(length, glm::dot(last, first));
  const double chord = length > 0.0 ? angle * glm::dot(n, cross) / length : 0.0;
  return std::max(0.0, -0.5 * (arc + chord));
}

}  // namespace

double diskIrradiance(const dvec3& center, const dvec3& axis, double radius, const dvec3& p, const dvec3& n) {
  const dvec3 d = p - center;
  const double z = glm::dot(d, axis);
  if (z <= 0.0) return 0.0;
  const dvec3 radial = d - z * axis;
  const double r = glm::length(radial);
  // Height over the receiver's plane: of the center, and how much the rim can add or take away.
  const double height = -glm::dot(n, d);
  const double cos_tilt = glm::dot(n, axis);
  const double reach = radius * std::sqrt(std::max(0.0, 1.0 - cos_tilt * cos_tilt));
  if (height <= -reach) return 0.0;
  if (height < reach) {
    return segmentIrradiance(center - p, axis, radius, n);
  }
  // Entirely above the horizon: E/L = n . vector irradiance. With s = r^2 + z^2 + a^2 and
  // q = sqrt(s^2 - 4 a^2 r^2): along -axis pi/2 (1 - (r^2 + z^2 - a^2)/q), along -radial
  // pi z/(2 r) (s/q - 1). Both differences cancel far away; rationalised:
  // 1 - (s - 2a^2)/q = ((q - s) + 2a^2)/q and q - s = -4a^2r^2/(q + s).
  const double a2 = radius * radius;
  const double r2 = r * r;
  const double s = r2 + z * z + a2;
  const double q = std::sqrt(std::max(0.0, s * s - 4.0 * a2 * r2));
  if (q <= 0.0) return 0.0;
  const double s_minus_q = 4.0 * a2 * r2 / (q + s);
  const double along_axis = 0.5 * kPi * (2.0 * a2 - s_minus_q) / q;
  // z/(2r) (s - q)/q = 2 a^2 r z / (q (q + s)): no division by r, and `radial` carries r.
  const double radial_factor = 0.5 * kPi * 4.0 * a2 * z / (q * (q + s));
  return std::max(0.0, -glm::dot(n, axis) * along_axis - glm::dot(n, radial) * radial_factor);
}

double sphereIrradiance(const dvec3& center, double radius, const dvec3& p, const dvec3& n) {
  const dvec3 d = center - p;
  const double distance2 = glm::dot(d, d);
  const double r2 = radius * radius;
  if (distance2 <= r2) return 0.0;
  const double distance = std::sqrt(distance2);
  const double cos_t = glm::dot(n, d) / distance;
  const double sin2_s = r2 / distance2;  // sigma: the angular radius
  const double h2 = distance2 / r2;
  const double k2 = 1.0 - h2 * cos_t * cos_t;
  if (k2 <= 0.0) return cos_t > 0.0 ? kPi * sin2_s * cos_t : 0.0;
  const double sin2_t = std::max(1.0 - cos_t * cos_t, 1e-300);
  const double x = std::clamp(-cos_t * std::sqrt((h2 - 1.0) / sin2_t), -1.0, 1.0);
  const double first = cos_t * std::acos(x) - std::sqrt(k2 * (h2 - 1.0));
  return std::max(0.0, first * sin2_s + std::atan(std::sqrt(k2 / (h2 - 1.0))));
}

double tubeIrradiance(const dvec3& center, const dvec3& axis, double half_length, double radius, const dvec3& p,
                      const dvec3& n) {
  const dvec3 d = p - center;
  const dvec3 radial = d - glm::dot(d, axis) * axis;
  const double rho = glm::length(radial);
  if (rho <= radius) return 0.0;
  const dvec3 e0 = radial / rho;
  const dvec3 e1 = glm::cross(axis, e0);
  const double alpha = std::acos(radius / rho);
  const auto point = [&](double phi, double s) {
    return -d + s * half_length * axis + radius * (std::cos(phi) * e0 + std::sin(phi) * e1);
  };
  // Is any part of the visible surface below the horizon? Its convex hull is in this box.
  const double swing = radius * (std::abs(glm::dot(n, e0)) + std::abs(glm::dot(n, e1)));
  const double middle = -glm::dot(n, d);
  const double along = half_length * std::abs(glm::dot(n, axis));
  if (middle + along + swing <= 0.0) return 0.0;
  if (middle - along - swing > 0.0) {
    // Contour counter-clockwise seen from p: up the +alpha tangent, back over the far arc, down
    // the -alpha tangent, forth over the near arc. E/L = -1/2 closed integral n.(v x dv)/|v|^2.
    const auto straight = [&](const dvec3& a, const dvec3& b) {
      const dvec3 cross = glm::cross(a, b);
      const double s = glm::length(cross);
      if (s <= 0.0) return 0.0;
      return 2.0 * std::atan2(s, glm::length(a) * glm::length(b) + glm::dot(a, b)) * glm::dot(n, cross) / s;
    };
    const auto arc = [&](double s) {  // from -alpha to +alpha at end s
      double sum = 0.0;
      for (std::size_t i = 0; i < kGaussNode.size(); ++i) {
        for (const double sign : {-1.0, 1.0}) {
          const double phi = alpha * sign * kGaussNode[i];
          const dvec3 v = point(phi, s);
          const dvec3 dv = radius * (-std::sin(phi) * e0 + std::cos(phi) * e1);
          sum += kGaussWeight[i] * alpha * glm::dot(n, glm::cross(v, dv)) / glm::dot(v, v);
        }
      }
      return sum;
    };
    const double sum = straight(point(alpha, -1.0), point(alpha, 1.0)) - arc(1.0) +
                       straight(point(-alpha, 1.0), point(-alpha, -1.0)) + arc(-1.0);
    return std::max(0.0, -0.5 * sum);
  }
  constexpr int kChords = 48;
  ContourSum sum(n);
  for (int i = 0; i <= kChords; ++i) sum.vertex(point(alpha * (1.0 - 2.0 * i / kChords), 1.0));
  for (int i = 0; i <= kChords; ++i) sum.vertex(point(alpha * (2.0 * i / kChords - 1.0), -1.0));
  return sum.value();
}

}  // namespace soffit::light

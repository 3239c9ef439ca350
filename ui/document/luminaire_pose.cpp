// SPDX-License-Identifier: MIT
#include "ui/document/luminaire_pose.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kAngleStep = 1e-3;   // deg
constexpr double kLengthStep = 1e-4;  // m
constexpr double kSmallest = 1e-3;    // m

double rounded(double v, double step) {
  // Divided by the inverse, for decimal numbers that look like them in the file.
  return std::round(v / step) / std::round(1.0 / step);
}

double wrapped(double angle_deg) {
  const double turns = std::remainder(angle_deg, 360.0);
  return turns <= -180.0 ? 180.0 : turns + 0.0;  // no negative zero
}

double size(double v, double factor) {
  return std::max(rounded(v * factor, kLengthStep), kSmallest);
}

double furthest(double a, double b) {
  return std::abs(std::log(a)) >= std::abs(std::log(b)) ? a : b;
}

struct Resizer {
  dvec3 f;
  double& scale;
  void operator()(light::PointShape&) const {}
  void operator()(light::Rectangle& r) const {
    r.width = size(r.width, f.x);
    r.height = size(r.height, f.y);
  }
  void operator()(light::Disk& d) const { d.radius = size(d.radius, furthest(f.x, f.y)); }
  void operator()(light::Sphere& s) const {
    s.radius = size(s.radius, furthest(furthest(f.x, f.y), f.z));
  }
  void operator()(light::Tube& t) const {
    t.length = size(t.length, f.x);
    t.radius = size(t.radius, furthest(f.y, f.z));
  }
  void operator()(light::Polygon& p) const {
    for (dvec2& corner : p.outline) corner *= dvec2(f);
  }
  void operator()(light::MeshShape&) const {
    scale = std::max(scale * furthest(furthest(f.x, f.y), f.z), 1e-4);
  }
};

}  // namespace

dvec3 rotationDegOf(const dmat3& r) {
  // Rz Ry Rx, columns first: r[0][2] = -sin y.
  const double sine = std::clamp(-r[0][2], -1.0, 1.0);
  constexpr double kPole = 1.0 - 1e-12;
  dvec3 angle(0.0, std::asin(sine), 0.0);
  if (std::abs(sine) > kPole) {
    angle.z = std::atan2(-r[1][0], r[1][1]);
  } else {
    angle.x = std::atan2(r[1][2], r[2][2]);
    angle.z = std::atan2(r[0][1], r[0][0]);
  }
  for (int i = 0; i < 3; ++i) angle[i] = wrapped(rounded(degrees(angle[i]), kAngleStep));
  return angle;
}

dvec3 aimedAlong(const dvec3& direction, const dvec3& before_deg) {
  const double flat = std::hypot(direction.x, direction.y);
  const double tilt = std::atan2(flat, -direction.z);  // from straight down
  const double azimuth = flat > 1e-9 ? degrees(std::atan2(direction.y, direction.x)) : before_deg.z;
  return {0.0, wrapped(rounded(-degrees(tilt), kAngleStep)), wrapped(rounded(azimuth, kAngleStep))};
}

void turn(light::Luminaire& luminaire, int axis, double angle_deg, const dvec3& pivot) {
  dvec3 by(0.0);
  by[axis] = angle_deg;
  const dmat3 rotation = rotationXyz(by);
  if (axis == 2) {
    // The last of the fixed axes: the other two angles stay what the user gave them.
    luminaire.rotation_deg.z = wrapped(rounded(luminaire.rotation_deg.z + angle_deg, kAngleStep));
  } else {
    luminaire.rotation_deg = rotationDegOf(rotation * rotationXyz(luminaire.rotation_deg));
  }
  const dvec3 from_pivot = luminaire.position - pivot;
  const dvec3 turned = rotation * from_pivot;
  for (int i = 0; i < 3; ++i) {
    if (turned[i] != from_pivot[i])
      luminaire.position[i] = rounded(pivot[i] + turned[i], kLengthStep);
  }
}

void resize(light::Luminaire& luminaire, const dvec3& factor) {
  std::visit(Resizer{factor, luminaire.scale}, luminaire.shape);
}

}  // namespace soffit::ui

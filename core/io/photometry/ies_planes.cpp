// SPDX-License-Identifier: MIT
#include "core/io/photometry/ies_planes.h"

#include "core/photometry/goniometer.h"
#include "core/photometry/planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace soffit::io {
namespace {

using photometry::Mirror;

// Angles are given to a few decimals; nobody means a plane at 89.9999 to be another one than 90.
constexpr double kAngleDeg = 1e-3;

bool is(double angle, double wanted) {
  return std::abs(angle - wanted) < kAngleDeg;
}

Result<void> checkRange(const std::vector<double>& angles, const char* which, double first,
                        double last) {
  if (angles.front() >= first - kAngleDeg && angles.back() <= last + kAngleDeg) return {};
  return Error{"",
               fmt::format("expected {} angles within {:g}..{:g}, found {:g}..{:g}", which, first,
                           last, angles.front(), angles.back()),
               "The angles are damaged, or the photometric type is another one."};
}

double widestStep(const std::vector<double>& angles) {
  double step = 0.0;
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
    step = std::max(step, angles[i + 1] - angles[i]);
  }
  return step;
}

struct Circle {
  Mirror mirror = Mirror::none;
  std::string name;
};

/// Which part of the circle the horizontal angles of type C cover.
Result<Circle> circleOf(const std::vector<double>& h) {
  if (h.size() == 1) return Circle{Mirror::none, "axial"};
  if (is(h.front(), 0.0) && is(h.back(), 90.0)) return Circle{Mirror::both, "quadrant 0-90"};
  if (is(h.front(), 0.0) && is(h.back(), 180.0)) return Circle{Mirror::c0, "bilateral 0-180"};
  if (is(h.front(), 90.0) && is(h.back(), 270.0)) return Circle{Mirror::c90, "bilateral 90-270"};
  if (is(h.front(), -90.0) && is(h.back(), 90.0)) return Circle{Mirror::c90, "bilateral -90-90"};
  // All round, if the gap that closes the circle is like the others.
  const double closing = h.front() + 360.0 - h.back();
  if (closing > -kAngleDeg && closing <= 1.5 * widestStep(h)) {
    return Circle{Mirror::none, fmt::format("none {:g}-{:g}", h.front(), h.back())};
  }
  return Error{"",
               fmt::format("expected horizontal angles 0, 0..90, 0..180, 90..270 or 0..360, found "
                           "{:g}..{:g}",
                           h.front(), h.back()),
               "The angles are damaged, or planes are missing."};
}

std::vector<double> clamped(std::vector<double> angles, double first, double last) {
  for (double& a : angles) a = std::clamp(a, first, last);
  return angles;
}

IesSphere sphereC(IesTable table) {
  const std::vector<double>& v = table.vertical_deg;
  const auto circle = circleOf(table.horizontal_deg);
  assert(circle);
  IesSphere sphere;
  sphere.symmetry = circle->name;
  const bool usual =
      (is(v.front(), 0.0) || is(v.front(), 90.0)) && (is(v.back(), 90.0) || is(v.back(), 180.0));
  if (!usual) {
    sphere.warnings.push_back(fmt::format(
        "the vertical angles cover {:g}..{:g} only; beyond them it is dark", v.front(), v.back()));
  }
  if (table.horizontal_deg.size() == 1 && !is(table.horizontal_deg[0], 0.0)) {
    sphere.warnings.push_back(
        fmt::format("the only plane is C{:g}; it is taken for all", table.horizontal_deg[0]));
  }
  sphere.distribution = photometry::unfold(
      {std::move(table.horizontal_deg), clamped(v, 0.0, 180.0), std::move(table.candela)},
      circle->mirror);
  sphere.lumens = sphere.distribution.flux();
  return sphere;
}

/// Greatest magnitude of V and of H: one is a latitude, the other a longitude.
std::pair<double, double> limitsAB(IesType type) {
  return type == IesType::b ? std::pair{180.0, 90.0} : std::pair{90.0, 180.0};
}

IesSphere sphereAB(IesTable table) {
  const bool is_b = table.type == IesType::b;
  const auto [v_limit, h_limit] = limitsAB(table.type);
  const bool mirrored = is(table.horizontal_deg.front(), 0.0);
  IesSphere sphere;
  sphere.symmetry =
      fmt::format("type {} {:g}-{:g} ({})", is_b ? 'B' : 'A', table.horizontal_deg.front(),
                  table.horizontal_deg.back(), mirrored ? "H mirrored" : "none");
  if (is(table.vertical_deg.front(), 0.0)) {
    sphere.warnings.emplace_back("the vertical angles start at 0; below that it is dark");
  }
  const photometry::GonioTable gonio{is_b ? photometry::GonioType::b : photometry::GonioType::a,
                                     clamped(std::move(table.vertical_deg), -v_limit, v_limit),
                                     clamped(std::move(table.horizontal_deg), -h_limit, h_limit),
                                     std::move(table.candela), mirrored};
  sphere.distribution = photometry::toCGamma(gonio);
  sphere.lumens = photometry::gonioFlux(gonio);
  return sphere;
}

}  // namespace

Result<void> checkIesAngles(IesType type, const std::vector<double>& vertical_deg,
                            const std::vector<double>& horizontal_deg) {
  if (type == IesType::c) {
    if (auto r = checkRange(vertical_deg, "vertical", 0.0, 180.0); !r) return r;
    if (auto r = checkRange(horizontal_deg, "horizontal", -180.0, 360.0); !r) return r;
    const auto circle = circleOf(horizontal_deg);
    return circle ? Result<void>{} : Result<void>{circle.error()};
  }
  const auto [v_limit, h_limit] = limitsAB(type);
  if (auto r = checkRange(vertical_deg, "vertical", -v_limit, v_limit); !r) return r;
  if (horizontal_deg.size() < 2) {
    return Error{"", "expected at least 2 horizontal angles for photometry of type A or B, found 1",
                 "Only type C can do with one."};
  }
  return checkRange(horizontal_deg, "horizontal", -h_limit, h_limit);
}

IesSphere toSphere(IesTable table) {
  return table.type == IesType::c ? sphereC(std::move(table)) : sphereAB(std::move(table));
}

}  // namespace soffit::io

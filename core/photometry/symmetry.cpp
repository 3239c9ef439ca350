// SPDX-License-Identifier: MIT
#include "core/photometry/symmetry.h"

#include <algorithm>
#include <cmath>

namespace soffit::photometry {
namespace {

/// Does I(C) equal I(image(C)) at all knots? Between knots both sides are linear in C, and the
/// knots of the image are tried as well since each knot is compared with its own image.
template <class Image>
bool invariant(const IntensityDistribution& d, double limit, const Image& image) {
  return std::all_of(d.c_deg.begin(), d.c_deg.end(), [&](double c) {
    return std::all_of(d.gamma_deg.begin(), d.gamma_deg.end(), [&](double gamma) {
      return std::abs(d.intensityAt(c, gamma) - d.intensityAt(image(c), gamma)) <= limit;
    });
  });
}

}  // namespace

Symmetry detectSymmetry(const IntensityDistribution& distribution, double tolerance) {
  const double limit = tolerance * distribution.peak();
  if (distribution.c_deg.size() < 2) return Symmetry::axial;
  if (invariant(distribution, limit, [](double) { return 0.0; })) return Symmetry::axial;
  const bool about_c0 = invariant(distribution, limit, [](double c) { return -c; });
  const bool about_c90 = invariant(distribution, limit, [](double c) { return 180.0 - c; });
  if (about_c0 && about_c90) return Symmetry::quadrant;
  if (about_c0) return Symmetry::about_c0;
  return about_c90 ? Symmetry::about_c90 : Symmetry::none;
}

std::string_view symmetryName(Symmetry symmetry) {
  switch (symmetry) {
    case Symmetry::axial:
      return "axial";
    case Symmetry::quadrant:
      return "quadrant";
    case Symmetry::about_c0:
      return "bilateral about C0-C180";
    case Symmetry::about_c90:
      return "bilateral about C90-C270";
    case Symmetry::none:
      break;
  }
  return "none";
}

}  // namespace soffit::photometry

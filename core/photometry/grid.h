// SPDX-License-Identifier: MIT
#pragma once

/// The grid of points on which EN 12464-1 wants illuminance calculated and verified.
namespace soffit::photometry {

/// Greatest spacing p in metres for a dimension d > 0 in metres: p = 0.2 · 5^(log10 d), at most 10.
double gridSpacing(double d);

/// Points along the two sides of a rectangle.
struct GridCounts {
  int nu = 1;
  int nv = 1;
};

/// Counts for a rectangle of u × v metres, both > 0: d is the longer side, or the shorter one if
/// the ratio of the sides is 2 or more; that side gets the nearest whole number of d/p, and the
/// resulting spacing fixes the other side (nearest whole number, at least 1).
GridCounts gridCounts(double u, double v);

}  // namespace soffit::photometry

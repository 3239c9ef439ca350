// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <span>

/// The GGX lobe as a linearly transformed cosine (Heitz, Dupuy, Hill & Neubelt 2016): what a
/// polygonal light sends through it in closed form.
///
/// A clamped cosine about +z, turned and stretched by a matrix M, has unit weight whatever M is;
/// and its integral over a polygon is that of the cosine over the polygon transformed by M^-1,
/// which is Lambert's formula. M is fitted here, by minimising the weighted third power of the
/// difference of the densities over samples of both.
namespace soffit::glossy {

/// One lobe, in the frame whose z is the normal and in which the eye is in the half plane y = 0,
/// x > 0.
struct Ltc {
  dmat3 matrix{1.0};      ///< M
  dmat3 inverse{1.0};     ///< M^-1
  double jacobian = 1.0;  ///< determinant of M^-1

  /// The lobe's density, sr^-1, at a unit direction of that frame.
  [[nodiscard]] double density(const dvec3& w) const;
};

/// The fit for one angle and alpha, without the table: some milliseconds.
Ltc fitLtc(double cos_view, double alpha);

/// From a table of 17 angles x 25 roughnesses (made once, on all threads, in about 0.4 s of one
/// core). cos_view is clamped to [0.02, 1], alpha to [0.0025, 1] (roughness 0.05).
///
/// Share of the lobe that lies elsewhere, 1/2 integral |difference|: at roughness 0.25 / 0.5 / 1
/// 0.01 / 0.03 / 0.02 at 30 degrees from the normal, 0.04 / 0.13 / 0.03 at 60, 0.25 / 0.30 / 0.07
/// at
/// 85. Error of a highlight: ltc_light.h.
Ltc ltcAt(double cos_view, double alpha);

}  // namespace soffit::glossy

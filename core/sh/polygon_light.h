// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/sh/index.h"

#include <span>
#include <vector>

/// SH coefficients of uniform polygonal lights seen from a point, without sampling, and how they
/// change as the point moves.
///
/// A polygon's outline is counter-clockwise seen from its emitting side, convex or not, in metres
/// in any one frame with the receiver; nearly planar is enough, since only the region of directions
/// that it covers matters. Luminance is 1: multiply by cd/m^2. The whole sphere is covered: nothing
/// is clipped at a horizon, which the receiver's own transfer brings along (numerics.md 1.5).
namespace soffit::sh {

/// Solid angle of the outline seen from p, steradians: positive on the emitting side, negative
/// behind, 0 in the plane. Signed triangles of a fan (Van Oosterom & Strackee 1983), so any simple
/// outline will do; exact to rounding.
double polygonSolidAngle(std::span<const dvec3> outline, const dvec3& p);

/// integral of y_lm over the directions from p to the light, for bands in 1 .. kMaxBands; all zero
/// behind or in the polygon's plane, and for fewer than 3 corners or no area. Repeated corners are
/// skipped.
///
/// The surface integral becomes one along the edges by Stokes' theorem and Laplace's equation
/// (Wang & Ramamoorthi 2018 have the same root): for l >= 1, 1 / (l (l + 1)) sum over the edges of
/// the integral of mu . grad y_lm, mu the edge's inward normal. Arcs of at most 60 degrees,
/// Gauss-Legendre with as many nodes as the arc and the bands need: error 1e-11 of the largest
/// coefficient at any distance above 1e-4 light sizes (far away rounding: 1e-16 x distance / size).
Coefficients polygonCoefficients(std::span<const dvec3> outline, const dvec3& p, int bands);

/// The same in closed form after Wang & Ramamoorthi 2018: integrals of P_l(w . d) over the light by
/// their recurrences along the edges, for 2 bands + 1 fixed lobe axes w, then a matrix to y_lm.
/// Error about 1e-13 of the largest coefficient; which of the two is faster: `soffit bench sh`.
Coefficients polygonCoefficientsClosedForm(std::span<const dvec3> outline, const dvec3& p,
                                           int bands);

/// Coefficients and their gradients by the receiver's position, unit sr^1/2 and sr^1/2 / m.
struct CoefficientsWithGradient {
  Coefficients values;
  std::vector<dvec3> gradients;  ///< one per coefficient

  /// First-order estimate at p + offset (metres); the error grows with (offset / distance)^2.
  [[nodiscard]] Coefficients at(const dvec3& offset) const;
};

/// polygonCoefficients() with gradients: the boundary moves by -dp / R, R the distance to the edge
/// (numerics.md 1.6). Singular where an edge passes through p. Zero behind the light.
CoefficientsWithGradient polygonCoefficientsWithGradient(std::span<const dvec3> outline,
                                                         const dvec3& p, int bands);

}  // namespace soffit::sh

// SPDX-License-Identifier: MIT
#pragma once

#include "core/glossy/ltc.h"
#include "core/light/emitter.h"
#include "core/math/vec.h"

#include <span>
#include <vector>

/// Highlights of area lights by linearly transformed cosines.
namespace soffit::glossy {

/// Where a lobe stands: a receiver and its eye.
class LobeFrame {
 public:
  /// normal and to_eye unit, to_eye above the surface; alpha > 0.
  LobeFrame(const dvec3& position, const dvec3& normal, const dvec3& to_eye, double alpha);

  /// Share of the lobe of unit weight that a polygon fills, seen from its front: counter-clockwise
  /// seen from its emitting side, in metres, convex or not; 0 from behind. What is below the
  /// receiver's horizon is cut off. Times luminance, Fresnel's term and the lobe's
  /// weight without it (LobeShape::scale + bias) and the share of the polygon that is not hidden
  /// this is the highlight's radiance.
  ///
  /// Error against numerical integration of GGX, RMS over lights of 0.3 to 2 m at 0.5 to 3 m about
  /// the reflected direction, as a share of the lobe's weight (tests/core/glossy/ltc_light_test):
  /// below 0.01 up to 45 degrees from the normal, 0.02 at 60, 0.065 at 80. The fit holds the core
  /// of the lobe; of its tails up to 0.1 falls below the horizon at grazing angles, which light all
  /// round would miss. (Scaling that up again was tried: highlights became twice as wrong.)
  [[nodiscard]] double share(std::span<const dvec3> outline) const;

 private:
  dvec3 position_;
  dmat3 local_;  ///< rows: tangent toward the eye, bitangent, normal
  Ltc ltc_;
};

/// What a receiver at p sees of an emitter as polygons that face it: planar shapes themselves
/// (disks by 24 corners of equal area), spheres as the disk that touches their cone of sight, tubes
/// as their outline between tangent lines (straight ends), meshes as their triangles that face p.
/// Empty for points, from behind, and inside a sphere or tube. Both sides of flat shapes with
/// measured photometry (Emitter::twoSided()).
std::vector<std::vector<dvec3>> facingOutlines(const light::Emitter& emitter, const dvec3& p);

}  // namespace soffit::glossy

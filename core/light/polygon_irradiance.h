// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <span>

/// Irradiance of uniform Lambertian emitters in closed form, unoccluded, divided by the
/// luminance L (so the unit is steradian times cosine: multiply by cd/m^2 to get lux).
/// Everything is double precision: the boundary sums cancel like (size/distance)^2.
namespace soffit::light {

/// Contour of a spherical region, clipped edge by edge to the horizon n.v > 0 and summed by
/// Lambert's formula E/L = 1/2 sum_i g_i n.(v_i x v_i+1)/|v_i x v_i+1| (numerics.md 1.4). Vertices
/// are relative to the receiver and run counter-clockwise as seen from it; the loop need not be
/// planar or convex. Feed edges in order with edge(), then take value().
class ContourSum {
 public:
  explicit ContourSum(const dvec3& n) : n_(n) {}
  /// The next vertex of the loop.
  void vertex(const dvec3& v);
  /// Closes the loop; E/L >= 0.
  double value();

 private:
  void clippedEdge(const dvec3& a, double ha, const dvec3& b, double hb);
  void addArc(const dvec3& a, const dvec3& b);

  dvec3 n_;
  double sum_ = 0.0;
  bool started_ = false;
  dvec3 first_{0.0}, last_{0.0};
  double first_height_ = 0.0, last_height_ = 0.0;
  bool has_exit_ = false, has_entry_ = false;
  dvec3 exit_{0.0}, entry_{0.0};
};

/// E/L at point p with unit normal n under a simple polygon, counter-clockwise seen from its
/// emitting side (convex or not). 0 when p is on or behind the polygon's plane is NOT checked
/// here: a back side gives a negative sum, returned as 0.
double polygonIrradiance(std::span<const dvec3> outline, const dvec3& p, const dvec3& n);

/// E/L under a disk of `radius` about `center` that emits toward its unit `axis`.
/// Unclipped: the vector irradiance of a disk in closed form (Howell, catalogue B-12 and B-13
/// combined by linearity); cut by the horizon: contour of a 256-gon of the same area (5e-8).
double diskIrradiance(const dvec3& center, const dvec3& axis, double radius, const dvec3& p, const dvec3& n);

/// E/L under a sphere that emits outwards; exact with any horizon (Snyder, "Area Light Sources
/// for Real-Time Graphics", 1996). 0 inside the sphere.
double sphereIrradiance(const dvec3& center, double radius, const dvec3& p, const dvec3& n);

/// E/L under the lateral surface of a cylinder, outside only. The contour of its visible part is
/// two tangent lines and two arcs; the arcs by Gauss-Legendre (1e-9 beyond one radius), or, cut by
/// the horizon, as chords. 0 inside and where only the ends are seen.
double tubeIrradiance(const dvec3& center, const dvec3& axis, double half_length, double radius, const dvec3& p,
                      const dvec3& n);

}  // namespace soffit::light

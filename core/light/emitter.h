// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/light/luminaire.h"
#include "core/math/box.h"
#include "core/math/vec.h"

#include <memory>
#include <vector>

namespace soffit::light {

enum class EmitterKind { point, planar, sphere, tube, mesh };

/// A luminaire made ready for computing: world geometry relative to a scene origin, and what it
/// emits per lumen-true unit. Dimming, on/off and colour are kept apart: they are re-mixed
/// without recomputing light (`gain`, `color`).
///
/// Everything an Emitter returns is for dimming 1 and luminance Y of the colour = 1, i.e. scalar
/// lux or cd; multiply by gain * color for RGB.
struct Emitter {
  EmitterKind kind = EmitterKind::planar;
  dvec3 position{0.0};       ///< relative to the scene origin
  dmat3 world_from_light{1.0};

  /// planar: outline, counter-clockwise seen from the emitting side; disk: empty, see radius.
  std::vector<dvec3> outline;
  dvec3 normal{0.0, 0.0, -1.0};  ///< planar: emission side
  bool disk = false;
  double radius = 0.0;        ///< disk, sphere, tube
  dvec3 axis{1.0, 0.0, 0.0};  ///< tube: unit
  double half_length = 0.0;   ///< tube

  /// mesh: world vertices (3 per triangle), unit outward normals and areas per triangle.
  std::vector<dvec3> corners;
  std::vector<dvec3> triangle_normals;
  std::vector<double> triangle_areas;

  /// Triangulation of the outline (indices into it, facing `normal`); empty for other kinds.
  std::vector<uvec3> outline_triangles;
  /// Running sums of the areas of the mesh's or the outline's triangles; the last is `area`.
  std::vector<double> area_sums;

  double area = 0.0;       ///< emitting area, m^2; 0 for a point
  double flux = 0.0;       ///< lumens at dimming 1
  double luminance = 0.0;  ///< cd/m^2, Lambertian shapes: flux / (pi area); else 0
  bool lambertian = true;  ///< Lambertian surface (or point with I0 cos gamma); false: isotropic or measured
  std::shared_ptr<const photometry::IntensityDistribution> table;  ///< measured; null otherwise
  double table_scale = 1.0;  ///< multiplies the table's candela

  bool casts_shadow = false;
  double gain = 1.0;      ///< dimming, 0 when off
  dvec3 color{1.0};       ///< linear Rec.709 with luminance Y = 1
  Box bounds;             ///< of the geometry, relative to the scene origin

  /// Far-field candela of the whole luminaire toward `direction` (unit, world), for measured,
  /// isotropic and point luminaires.
  [[nodiscard]] double pointIntensity(const dvec3& direction) const;

  /// Intensity per emitting area (cd/m^2) of a surface element with unit normal `n` toward
  /// `direction`: luminance * max(0, n.direction) for Lambertian emitters, table(direction) / area
  /// for measured ones (whatever the normal; interfaces.md, Photometry on shapes).
  [[nodiscard]] double intensityPerArea(const dvec3& n, const dvec3& direction) const;

  /// Both sides emit (measured photometry on a flat shape).
  [[nodiscard]] bool twoSided() const { return table != nullptr; }
};

/// Makes an emitter. `origin` is the scene origin that is subtracted from positions.
/// Errors: degenerate shapes (zero size, polygon with fewer than 3 corners or self-crossing),
/// non-finite numbers, negative flux, a mesh without triangles.
Result<Emitter> makeEmitter(const Luminaire& luminaire, const dvec3& origin = dvec3(0.0));

/// Linear Rec.709 of a colour, scaled to luminance Y = 0.2126 R + 0.7152 G + 0.0722 B = 1.
dvec3 emissionColor(const Colour& colour);

/// Luminance weights of linear Rec.709.
inline constexpr dvec3 kLuminance{0.2126390058715104, 0.7151686787677560, 0.0721923153607336};

}  // namespace soffit::light

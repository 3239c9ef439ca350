// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/prepared_light.h"
#include "core/math/vec.h"
#include "core/sh/index.h"
#include "core/sh/polygon_light.h"

#include <optional>
#include <vector>

/// Luminaires in the room as harmonics: light coefficients about any point, with the exact
/// attenuation by distance that Fujita & Kanai's virtual sphere stands in for.
namespace soffit::prt {

/// A luminaire made ready. Everything is for dimming 1 and a colour of Y = 1; lengths in m,
/// scene-local; coefficients in cd/m^2 sr^1/2, world axes, of all directions (a receiver's transfer
/// holds its own hemisphere). Nothing is in the way of the light.
class LuminaireLight {
 public:
  explicit LuminaireLight(const light::Emitter& emitter);

  [[nodiscard]] const light::Emitter& emitter() const { return light_.emitter(); }

  /// Whether p sees none of the emitting side.
  [[nodiscard]] bool dark(const dvec3& p) const;
  /// Metres from p to the luminaire's bounds; 0 inside.
  [[nodiscard]] double distance(const dvec3& p) const;

  /// Coefficients at p. Uniform planar shapes in closed form along the edges
  /// (sh::polygonCoefficients; a disk as a polygon of 48 corners and equal area: 3e-3 of L where it
  /// fills the sky, 1e-5 from two radii on), tubes
  /// as the rectangle that they look like, spheres as zonal caps, all else by the quadrature
  /// points of light::PreparedLight (5e-3 of the largest coefficient).
  [[nodiscard]] sh::Coefficients at(const dvec3& p, int bands) const;

  /// The same with position gradients, for receivers around p (Annen et al. 2004); nothing where
  /// the luminaire has no closed form or p sees it at a grazing angle. E error (offset/distance)^2.
  [[nodiscard]] std::optional<sh::CoefficientsWithGradient> around(const dvec3& p, int bands) const;

 private:
  /// Of a uniform planar shape or tube, as p sees it; empty for others.
  [[nodiscard]] std::vector<dvec3> outlineFrom(const dvec3& p) const;
  [[nodiscard]] sh::Coefficients bySamples(const dvec3& p, int bands) const;

  light::PreparedLight light_;
  std::vector<dvec3> outline_;  ///< of uniform planar shapes
  bool uniform_sphere_ = false;
  bool uniform_tube_ = false;
};

}  // namespace soffit::prt

// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/material.h"

namespace soffit::daylight {

/// Light through a clear sheet: plane-parallel slab, unpolarised Fresnel reflection at both faces,
/// incoherent multiple reflections inside, absorption by Beer's law, no lateral shift
/// (interfaces.md, Materials). Per polarisation, with r the reflectance of one face and a the
/// transmittance of one pass inside,
///   T = (1 - r)^2 a / (1 - r^2 a^2),   R = r (1 + a T)
/// (Born & Wolf § 1.5 for r; Siegel & Howell ch. 17 for the net sums); a = a_0^(1 / cos theta_t),
/// and a_0 follows from the glass's transmittance at normal incidence.
class Slab {
 public:
  /// A transmittance above the lossless one of the index is taken as that one: no absorption.
  explicit Slab(const scene::Glass& glass);

  struct Shares {
    double transmitted;
    double reflected;
  };
  /// At the angle of incidence whose cosine (its sign does not matter) is given; at grazing 0
  /// and 1.
  [[nodiscard]] Shares at(double cos_incidence) const;
  [[nodiscard]] double index() const { return index_; }
  /// ln of what one pass inside lets through at normal incidence; -infinity: nothing.
  [[nodiscard]] double logPass() const { return log_pass_; }

 private:
  double index_;
  double log_pass_;  ///< ln a_0; -infinity: opaque
};

}  // namespace soffit::daylight

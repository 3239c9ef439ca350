// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/sh/polygon_light.h"

#include <array>
#include <functional>
#include <span>
#include <vector>

/// A light's coefficients all over a volume from few evaluations: known with position gradients at
/// the points of a grid, blended between them (Annen et al. 2004; Wu et al. 2020).
namespace soffit::sh {

/// Points origin + spacing (i, j, k), i fastest.
struct GridPlaces {
  dvec3 origin{0.0};
  dvec3 spacing{1.0};                 ///< metres, above 0
  std::array<int, 3> count{2, 2, 2};  ///< along x, y, z, each at least 1

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) *
           static_cast<std::size_t>(count[2]);
  }
  [[nodiscard]] dvec3 at(std::size_t i) const;
};

/// Blends f_c + (p - x_c) . g_c / 2 of the eight points around p with trilinear weights. The half
/// is no slip: values alone are off by + t (1 - t) h^2 f'' / 2, first-order estimates alone by as
/// much the other way, their mean by the third power of the spacing h only. Along an axis with one
/// point the whole gradient is used, for receivers close to a plane.
class GradientGrid {
 public:
  using Evaluate = std::function<CoefficientsWithGradient(const dvec3& p)>;

  /// Calls `evaluate` once per point, on all threads; it must be pure, always return as many
  /// coefficients (at most kMaxCoefficients), and not throw.
  GradientGrid(const GridPlaces& places, const Evaluate& evaluate);

  [[nodiscard]] std::size_t evaluations() const { return places_.size(); }

  /// Coefficients at p; outside the grid those of the nearest cell, continued. No light should hang
  /// within a spacing of p: gradients are unbounded at its edges. About 1 ns per coefficient and
  /// corner.
  void at(const dvec3& p, std::span<double> coefficients) const;

 private:
  GridPlaces places_;
  std::size_t coefficients_ = 0;
  std::vector<double> values_;    ///< [point][coefficient]
  std::vector<dvec3> gradients_;  ///< [point][coefficient]
};

}  // namespace soffit::sh

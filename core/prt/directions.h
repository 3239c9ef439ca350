// SPDX-License-Identifier: MIT
#pragma once

#include "core/sh/sphere_samples.h"

#include "core/math/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soffit::prt {

/// The directions that every receiver of a bake shares (the tutorial; Fujita & Kanai), with the SH
/// basis at each: which of them are blocked is one bit each, and a transfer vector is a sum of
/// rows of the table.
///
/// Ordered along a space-filling curve on a cube, so that 16 neighbours make a coherent packet; no
/// result depends on their order but by rounding. 4 bytes x directions x (n^2 rounded up to 16).
class Directions {
 public:
  /// samples: at least one, weights in steradians that sum to 4 pi (sh::stratifiedSamples,
  /// sh::hammersleySamples, ..); bands in 1 .. sh::kMaxBands.
  Directions(const sh::SphereSamples& samples, int bands);

  [[nodiscard]] std::size_t size() const { return directions_.size(); }
  [[nodiscard]] int bands() const { return bands_; }
  [[nodiscard]] std::size_t coefficients() const;

  [[nodiscard]] const vec3& operator[](std::size_t i) const { return directions_[i]; }
  [[nodiscard]] std::span<const vec3> all() const { return directions_; }
  /// Steradians.
  [[nodiscard]] float weight(std::size_t i) const { return weights_[i]; }

  /// Row i holds weight x y_lm for every coefficient, then zeros up to rowStride().
  [[nodiscard]] const float* table() const { return table_.data(); }
  [[nodiscard]] std::size_t rowStride() const { return stride_; }

 private:
  int bands_;
  std::size_t stride_;
  std::vector<vec3> directions_;
  std::vector<float> weights_;
  std::vector<float> table_;
};

}  // namespace soffit::prt

// SPDX-License-Identifier: MIT
#pragma once

#include "core/glossy/parallax.h"

#include <span>
#include <vector>

namespace soffit::glossy {

/// How well a probe sees a place, without the hard border that a map of distances gives: the edge
/// of what a probe sees would be an edge in what reflects.
///
/// Mean and mean square of the distances within a cone about every direction; Chebyshev's
/// inequality bounds the share of them that lie as far as the place or farther (variance shadow
/// maps, Donnelly & Lauritzen 2006; for probes Majercik et al. 2019). Before and behind an
/// occluder at two distances the bound is that share: it falls evenly over the width of the cone.
class ProbeSight {
 public:
  static constexpr int kSide = 32;
  static constexpr float kCone = 0.1F;        ///< rad, half of it
  static constexpr float kFarthest = 100.0F;  ///< m: where nothing is, and beyond
  /// Of the way to a place, what must be seen of it at least: surfaces have slopes and facets.
  static constexpr float kShare = 0.97F;
  static constexpr float kLeastDeviation = 0.01F;  ///< of the way
  static constexpr float kHidden = 0.2F;           ///< shares below count as nothing

  explicit ProbeSight(const ProbeDepth& depth);

  /// 0 .. 1 for a place at `from_probe`, m.
  [[nodiscard]] float of(const vec3& from_probe) const;

  /// Mean, m, and mean square, m^2: [face][row][column], kSide + 2 rows and columns each; round
  /// each face a rim of what lies beyond its edges.
  [[nodiscard]] std::span<const vec2> rimmed() const { return moments_; }

 private:
  std::vector<vec2> moments_;
};

}  // namespace soffit::glossy

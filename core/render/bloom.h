// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <span>
#include <vector>

namespace soffit::render {

/// The light that an eye or a lens spreads about what is much brighter than all else. An effect for
/// pictures, never for numbers: off unless asked for.
struct Bloom {
  double threshold = 0.0;  ///< cd/m^2; what a pixel has beyond it is spread. 0: no bloom
  double strength = 0.1;   ///< share of that which is spread, 0..1

  friend bool operator==(const Bloom&, const Bloom&) = default;
};

/// radiance  width x height, row by row, linear Rec.709, cd/m^2; in place.
///
/// L' = L - s B + s (K * B), B = L max(0, 1 - threshold / Y): light is neither made nor lost, but
/// for what is spread beyond the picture's edge. K is a sum of three Gaussians with standard
/// deviations of 0.4, 1.6 and 6 % of the height and shares of 0.5, 0.3 and 0.2, which falls off
/// like the veil that the eye itself makes (about 1/r^2; Spencer et al. 1995, "Physically-Based
/// Glare Effects for Digital Images"). Each is five running means (Kovesi 2010, "Fast
/// Almost-Gaussian Filtering"): time does not depend on the width. Pixels that are not finite count
/// as black.
void addBloom(std::span<vec3> radiance, int width, int height, const Bloom& bloom);

/// s (K * B) alone, for a picture that takes s B from its pixels itself; empty where nothing exceeds
/// the threshold. The picture may be a smaller one of the same view: what is spread is smooth.
std::vector<vec3> spreadLight(std::span<const vec3> radiance, int width, int height,
                              const Bloom& bloom);

}  // namespace soffit::render

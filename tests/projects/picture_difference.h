// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/material.h"

/// How different two pictures look, for tests against stored ones.
namespace soffit {

/// All in units of CIE 1976 L*a*b*: a difference of 1 is about what an observer can just see.
struct PictureDifference {
  double mean = 0.0;  ///< of the pixels' Delta E*ab
  double p95 = 0.0;   ///< 95th percentile of it
  double p99 = 0.0;   ///< 99th percentile of it: the one pixel in a hundred that is worst
  /// Median of the pixels' L* in `shown` minus `stored`: what a change of exposure or flux does to
  /// all, and errors in a few corners do not.
  double lightness = 0.0;
};

/// Compares two pictures of one size, three channels each, linear display light (0..1, Rec.709,
/// white D65).
///
/// Both are smoothed first (binomial 1 4 6 4 1 in both directions, about what an eye averages at a
/// size where the picture fills some degrees), so that the noise of single samples and stairs at
/// edges do not count. Source: CIE 15:2004, 8.2.1.
PictureDifference pictureDifference(const scene::Image& shown, const scene::Image& stored);

}  // namespace soffit

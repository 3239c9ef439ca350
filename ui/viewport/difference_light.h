// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/light_frame.h"

namespace soffit::ui {

/// The difference of two lights as a light that a view can show: 0 lx stands for -range, range
/// for no difference, 2 range for +range; what is beyond is cut. A look with `difference` and
/// the range {0, 2 range} gives it its colors.
///
/// first, second  of one solver. range  lux, above 0.
LightFramePtr differenceLight(const LightFrame& first, const LightFrame& second, double range);

/// A round value that covers all but two percent of the differences, lux.
double fittingDifference(const LightFrame& first, const LightFrame& second);

}  // namespace soffit::ui

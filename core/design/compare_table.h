// SPDX-License-Identifier: MIT
#pragma once

#include "core/design/compare.h"

#include <span>
#include <string>

namespace soffit::design {

/// A table to read: a block per work plane with a line per layout (mean, least and greatest lux,
/// uniformity, and the mean against that of the first layout), then the flux.
std::string compareText(std::span<const LayoutFigures> layouts);

/// A row per layout and work plane (one without a plane when there are none), comma-separated,
/// names quoted where they need it. Columns: layout, work_plane, points, mean_lx, min_lx, max_lx,
/// u0, ud, mean_difference_lx, mean_difference_percent, min_difference_lx, max_difference_lx,
/// luminaires_on, emitted_lm, installed_lm, lm_per_m2. Differences are to the first layout; the
/// percentage is empty where its mean is 0.
std::string compareCsv(std::span<const LayoutFigures> layouts);

/// A text as a field of a CSV row: quoted where it needs it (RFC 4180).
std::string csvField(const std::string& text);

}  // namespace soffit::design

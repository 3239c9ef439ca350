// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace soffit::photometry {

/// What a lighting table says of a field of values (illuminance on a work plane, say).
struct FieldMetrics {
  std::size_t count = 0;
  double mean = 0.0;
  double min = 0.0;
  double max = 0.0;
  double u0 = 0.0;  ///< uniformity min / mean (EN 12464-1); 0 where the mean is 0
  double ud = 0.0;  ///< diversity min / max; 0 where the maximum is 0
};

/// Metrics of equally weighted, finite values ≥ 0; all zero for an empty field. Units: the values'.
FieldMetrics fieldMetrics(std::span<const double> values);

/// The value below which `fraction` (0..1) of the values lie, linear between order statistics
/// (Hyndman & Fan 1996, type 7). 0 for an empty field.
double percentile(std::span<const double> values, double fraction);

}  // namespace soffit::photometry

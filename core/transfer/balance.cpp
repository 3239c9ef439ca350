// SPDX-License-Identifier: MIT
#include "core/transfer/balance.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace soffit::transfer {
namespace {

/// Mean of how far quotients are from 1. Large ones count, but not as squares: of a few lights that
/// touch a wall texels get the sum wrong in any room.
double usualDeviation(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t t = 0; t < a.size(); ++t) {
    if (!(a[t] > 0.0 && b[t] > 0.0)) continue;
    sum += std::abs(a[t] / b[t] - 1.0);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace

float trustInConservation(const TrainingFields& fields, std::span<const double> gathered,
                          std::span<const double> interpolated, const Operators& operators) {
  const auto count = static_cast<std::size_t>(fields.count);
  std::vector<double> sent(count, 0.0);
  for (std::size_t s = 0; s < operators.sends.size(); ++s) {
    for (std::size_t t = 0; t < count; ++t) {
      sent[t] += static_cast<double>(operators.sends[s]) *
                 static_cast<double>(fields.value[s * count + t]);
    }
  }
  const double quadrature = usualDeviation(sent, gathered);
  const double interpolation = usualDeviation(interpolated, gathered);
  // Fourth powers: where areas err clearly less than lists the law is kept almost whole.
  const double q4 = std::pow(quadrature, 4);
  const double g4 = std::pow(interpolation, 4);
  return g4 + q4 > 0.0 ? static_cast<float>(std::max(0.0, (g4 - q4) / (g4 + q4))) : 1.0F;
}

}  // namespace soffit::transfer

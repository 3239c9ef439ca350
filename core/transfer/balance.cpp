// SPDX-License-Identifier: MIT
#include "core/transfer/balance.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace soffit::transfer {
namespace {

/// Half of the quotients differ from 1 by less than this.
double usualDeviation(std::span<const double> a, std::span<const double> b) {
  std::vector<double> apart;
  for (std::size_t t = 0; t < a.size(); ++t) {
    if (a[t] > 0.0 && b[t] > 0.0) apart.push_back(std::abs(a[t] / b[t] - 1.0));
  }
  if (apart.empty()) return 0.0;
  const auto middle = apart.begin() + static_cast<std::ptrdiff_t>(apart.size() / 2);
  std::nth_element(apart.begin(), middle, apart.end());
  return *middle;
}

}  // namespace

float trustInConservation(const TrainingFields& fields, std::span<const double> gathered,
                          std::span<const double> interpolated, const Operators& operators) {
  const auto count = static_cast<std::size_t>(fields.count);
  std::vector<double> sent(count, 0.0);
  for (std::size_t s = 0; s < operators.sends.size(); ++s) {
    for (std::size_t t = 0; t < count; ++t) {
      sent[t] += static_cast<double>(operators.sends[s]) * static_cast<double>(fields.value[s * count + t]);
    }
  }
  const double quadrature = usualDeviation(sent, gathered);
  const double interpolation = usualDeviation(interpolated, gathered);
  const double both = quadrature * quadrature + interpolation * interpolation;
  return both > 0.0 ? static_cast<float>(interpolation * interpolation / both) : 1.0F;
}

}  // namespace soffit::transfer

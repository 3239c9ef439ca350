// SPDX-License-Identifier: MIT
#pragma once

#include "core/sh/index.h"

#include <array>

/// The numbers of the recurrence that evaluates the basis:
/// Q_lm = A_lm z Q_{l-1,m} + B_lm Q_{l-2,m}, starting from Q_mm (a constant), and
/// y_{l,m} = Q_lm Re (x + i y)^m, y_{l,-m} = Q_lm Im (x + i y)^m.
namespace soffit::sh {

template <class Real>
struct RecurrenceStep {
  Real a = 0;  ///< A_lm; 0 where l = m
  Real b = 0;  ///< B_lm; 0 where l <= m + 1
};

template <class Real>
struct Recurrence {
  std::array<Real, kMaxBands> start{};  ///< Q_mm, with the factor sqrt 2 of m > 0
  /// At [m][l], l >= m.
  std::array<std::array<RecurrenceStep<Real>, kMaxBands>, kMaxBands> step{};
};

/// Made once, at first use; safe from any thread. Real: float or double.
template <class Real>
const Recurrence<Real>& recurrence();

}  // namespace soffit::sh

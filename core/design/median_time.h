// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace soffit::design {

/// Seconds that one call of `run` takes: the median over batches that are each long enough for the
/// clock (20 microseconds), at least three of them, for about `budget_s`.
double medianSeconds(const std::function<void()>& run, double budget_s);

}  // namespace soffit::design

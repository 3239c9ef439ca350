// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace soffit::design {

/// A choice that costs something and errs by something; less is better in both.
struct Tradeoff {
  double cost = 0.0;
  double error = 0.0;
};

/// Indices of the choices that no other beats in one respect without losing in the other, by
/// rising cost. Of equal choices the first counts; what is not finite never does. O(n log n).
std::vector<std::size_t> paretoFront(std::span<const Tradeoff> choices);

}  // namespace soffit::design

// SPDX-License-Identifier: MIT
#include "core/design/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soffit::design {

std::vector<std::size_t> paretoFront(std::span<const Tradeoff> choices) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (std::isfinite(choices[i].cost) && std::isfinite(choices[i].error)) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Tradeoff& x = choices[a];
    const Tradeoff& y = choices[b];
    return x.cost != y.cost ? x.cost < y.cost : x.error < y.error;
  });
  std::vector<std::size_t> front;
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (choices[i].error >= best) continue;
    best = choices[i].error;
    front.push_back(i);
  }
  return front;
}

}  // namespace soffit::design

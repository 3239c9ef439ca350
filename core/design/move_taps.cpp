// SPDX-License-Identifier: MIT
#include "core/design/move_taps.h"

namespace soffit::design {
namespace {

constexpr double kPerWeight = 2.0 / 3.0;
constexpr double kPerBlock = 15.0;
constexpr double kPerTexel = 100.0;

}  // namespace

double moveTaps(const transfer::Operators& operators, int sweeps) {
  const auto count = [](const auto& list) { return static_cast<double>(list.size()); };
  const double texels = count(operators.lists.entries) + kPerWeight * count(operators.weights);
  return (1.0 + sweeps) * texels + count(operators.node_lists.entries) +
         count(operators.node_lists.constants.entries) +
         kPerBlock * count(operators.nodes.matrix.blocks) +
         kPerTexel * static_cast<double>(operators.texels.slotCount());
}

}  // namespace soffit::design

// SPDX-License-Identifier: MIT
#include "core/design/move_taps.h"

namespace soffit::design {
namespace {

constexpr double kPerWeight = 2.0 / 3.0;
constexpr double kPerBlock = 15.0;
constexpr double kPerTexel = 100.0;

}  // namespace

double moveTaps(const transfer::Operators& operators) {
  const auto count = [](const auto& list) { return static_cast<double>(list.size()); };
  return count(operators.lists.entries) + count(operators.node_lists.entries) +
         count(operators.node_lists.constants.entries) + kPerWeight * count(operators.weights) +
         kPerBlock * count(operators.nodes.matrix.blocks) +
         kPerTexel * static_cast<double>(operators.texels.slotCount());
}

}  // namespace soffit::design

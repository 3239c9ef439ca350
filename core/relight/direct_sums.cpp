// SPDX-License-Identifier: MIT
#include "core/relight/direct_sums.h"

#include "core/base/parallel.h"
#include "core/transfer/kernels.h"

#include <algorithm>

namespace soffit::relight {

void DirectSums::add(const Column& one, double gain, const dvec3& color,
                     const transfer::Operators& operators) {
  auto sum = std::ranges::find(sums_, color, &Sum::color);
  if (sum == sums_.end()) {
    sum = sums_.insert(sum, {color, {}});
    sum->column.direct.assign(one.direct.size(), 0.0F);
    sum->column.lit.assign(one.lit.size(), 0);
  }
  const auto& clusters = operators.texels.receivers.clusters;
  const auto factor = static_cast<float>(gain);
  parallelFor(clusters.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (one.lit[k] == 0) continue;
      sum->column.lit[k] = 1;
      transfer::addScaled(factor, &one.direct[clusters[k].begin],
                          &sum->column.direct[clusters[k].begin],
                          clusters[k].end - clusters[k].begin);
    }
  });
}

void DirectSums::reflect(const Solver& solver, std::span<const float> open, StageTimes* times) {
  for (Sum& sum : sums_) solver.indirect(sum.column, open, nullptr, times);
}

std::vector<WeightedColumn> DirectSums::lights() const {
  std::vector<WeightedColumn> out;
  for (const Sum& sum : sums_) out.push_back({&sum.column, sum.color});
  return out;
}

}  // namespace soffit::relight

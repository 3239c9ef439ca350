// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/light_sum.h"
#include "core/relight/solver.h"

#include <list>
#include <span>
#include <vector>

namespace soffit::relight {

/// Luminaires of one colour as one light: their direct light is added up and reflected once,
/// however many they are (design.md § 1). Energy is conserved by the sum instead of by the
/// luminaire (Solver::indirect()), which differs far below the error of either.
class DirectSums {
 public:
  /// Adds gain times the direct light of a column.
  void add(const Column& one, double gain, const dvec3& color,
           const transfer::Operators& operators);
  /// Reflects what was added; open and times as Solver::indirect() has them.
  void reflect(const Solver& solver, std::span<const float> open, StageTimes* times = nullptr);
  /// A column per colour, times the colour. Valid as long as this is.
  [[nodiscard]] std::vector<WeightedColumn> lights() const;

 private:
  struct Sum {
    dvec3 color;
    Column column;
  };
  std::list<Sum> sums_;
};

}  // namespace soffit::relight

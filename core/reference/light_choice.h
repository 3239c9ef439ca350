// SPDX-License-Identifier: MIT
#pragma once

#include "core/reference/light_shape.h"

#include <span>
#include <vector>

namespace soffit::reference {

/// Chooses one luminaire for a receiver with a probability that follows what each could send
/// there without obstacles: flux over squared distance times rough cosines. A luminaire that can
/// light the receiver always has a positive probability.
class LightChoice {
 public:
  struct Picked {
    std::size_t light = 0;
    double probability = 0.0;  ///< 0: no luminaire can light the receiver
  };

  /// Prepares the probabilities for a receiver at y with unit normal n (the zero vector for one
  /// that receives from all around). Lights whose gain is 0 are never chosen.
  void prepare(std::span<const LightShape> lights, const dvec3& y, const dvec3& n);

  /// u in [0, 1).
  [[nodiscard]] Picked pick(double u) const;
  [[nodiscard]] double probability(std::size_t light) const;

 private:
  std::vector<double> sums_;  ///< running sums of the weights
};

}  // namespace soffit::reference

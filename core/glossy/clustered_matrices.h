// SPDX-License-Identifier: MIT
#pragma once

#include "core/glossy/cpca.h"
#include "core/glossy/receiver_blocks.h"
#include "core/sh/index.h"

#include <span>
#include <vector>

namespace soffit::glossy {

/// Transfer matrices in the form of Sloan et al. 2003: light passes a mean and a few components per
/// cluster, and a receiver adds them up.
///
/// The matrices are those of visibility, linear in its (2n-1)^2 coefficients v; so these are
/// clustered, scaled per band so that their Euclidean distance is the Frobenius distance of the
/// matrices. Errors are shares of the matrices' Frobenius norm: the RMS error of what arrives under
/// random light.
class ClusteredMatrices {
 public:
  /// visibility: per receiver (2 bands - 1)^2 numbers, row-major; bands in 1 .. kMaxMatrixBands.
  ClusteredMatrices(std::span<const float> visibility, int bands, const CpcaOptions& options);

  [[nodiscard]] int bands() const { return bands_; }
  [[nodiscard]] std::size_t receivers() const { return slot_of_.size(); }
  /// Receivers are stored cluster by cluster, in blocks of 16 of one cluster.
  [[nodiscard]] std::size_t slots() const { return weights_.receivers(); }
  [[nodiscard]] std::size_t slotOf(std::size_t receiver) const { return slot_of_[receiver]; }
  [[nodiscard]] std::size_t bytes() const;

  /// The error that `rank` components leave (Cpca::predictedError()), and the measured one.
  [[nodiscard]] double predictedError(std::size_t rank) const { return predicted_[rank]; }
  [[nodiscard]] double measuredError() const { return measured_; }

  /// arriving: slots() receivers of 3 bands^2 rows. light: bands^2 coefficients per channel.
  void apply(const sh::RgbCoefficients& light, FloatBlocks& arriving) const;

 private:
  int bands_;
  std::size_t columns_;       ///< 1 and the components
  std::vector<float> basis_;  ///< [cluster][column][(2 bands - 1)^2], unscaled
  std::vector<std::uint32_t> cluster_of_block_;
  std::vector<std::uint32_t> slot_of_;
  HalfBlocks weights_;  ///< [column]; the first is 1
  std::vector<double> predicted_;
  double measured_ = 0.0;
};

/// Per band l of visibility the norm sqrt(sum over i, j of C_ijk^2) of the matrix of a unit
/// coefficient v_lm; the same for all m. 2 bands - 1 numbers.
std::vector<double> matrixNorms(int bands);

}  // namespace soffit::glossy

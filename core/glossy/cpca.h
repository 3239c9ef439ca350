// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/half.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Clustered principal components (Sloan, Hall, Hart & Snyder 2003): many vectors in few clusters,
/// each vector the mean of its cluster plus a few components.
namespace soffit::glossy {

struct CpcaOptions {
  int clusters = 64;
  int rank = 8;    ///< components per cluster, at most 32; less where a cluster has no more
  int rounds = 4;  ///< of assigning vectors anew to the cluster that fits them best
  std::uint64_t seed = 1;
};

/// One cluster: mean and components, rows of `dimension` numbers.
struct CpcaCluster {
  std::vector<float> mean;
  std::vector<float> components;  ///< orthonormal rows, by falling variance
  std::vector<double> variances;  ///< sum over the members of squared coefficients, per component
  double total = 0.0;             ///< sum over the members of squared distance from the mean
  std::size_t members = 0;
};

/// A low-rank form of `count` vectors. Deterministic for a seed, on any number of threads.
class Cpca {
 public:
  /// vectors: count x dimension, row-major; error is measured in their Euclidean norm, so scale
  /// first what counts more. k-means from vectors drawn far apart (k-means++, Arthur &
  /// Vassilvitskii 2007), then rounds of components by subspace iteration and assignment by the
  /// error that is left (among the 8 clusters with the nearest means).
  Cpca(std::span<const float> vectors, std::size_t dimension, const CpcaOptions& options);

  [[nodiscard]] std::size_t count() const { return cluster_of_.size(); }
  [[nodiscard]] std::size_t dimension() const { return dimension_; }
  [[nodiscard]] std::size_t rank() const { return rank_; }
  [[nodiscard]] std::span<const CpcaCluster> clusters() const { return clusters_; }
  [[nodiscard]] std::uint32_t clusterOf(std::size_t vector) const { return cluster_of_[vector]; }
  /// rank() coefficients, zero beyond the components of the cluster.
  [[nodiscard]] std::span<const transfer::Half> coefficients(std::size_t vector) const {
    return std::span(coefficients_).subspan(vector * rank_, rank_);
  }

  /// out.size() == dimension().
  void reconstruct(std::size_t vector, std::span<float> out) const;

  /// Means and components in float, coefficients in binary16, two bytes for the cluster's number.
  [[nodiscard]] std::size_t bytes() const;

  /// RMS error that `rank` components leave, as a share of the RMS of the vectors, from the
  /// variances alone: what a slider shows before anything is computed. rank <= rank().
  [[nodiscard]] double predictedError(std::size_t rank) const;
  /// The same measured against the vectors that it was made from, rounding included.
  [[nodiscard]] double measuredError(std::span<const float> vectors) const;

 private:
  std::size_t dimension_;
  std::size_t rank_;
  std::vector<CpcaCluster> clusters_;
  std::vector<std::uint32_t> cluster_of_;
  std::vector<transfer::Half> coefficients_;
  double square_ = 0.0;  ///< of all vectors
};

}  // namespace soffit::glossy

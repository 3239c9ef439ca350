// SPDX-License-Identifier: MIT
#include "core/glossy/clustered_matrices.h"

#include "core/base/parallel.h"
#include "core/glossy/matrix_kernels.h"
#include "core/glossy/transfer_matrix.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::glossy {

std::vector<double> matrixNorms(int bands) {
  std::vector<double> norms;
  for (int l = 0; l < 2 * bands - 1; ++l) {
    sh::Coefficients v(sh::coefficientCount(2 * bands - 1), 0.0);
    v[sh::index(l, 0)] = 1.0;
    double sum = 0.0;
    for (const double element : matrixFromVisibility(v, bands)) sum += element * element;
    norms.push_back(std::sqrt(sum));
  }
  return norms;
}

ClusteredMatrices::ClusteredMatrices(std::span<const float> visibility, int bands,
                                     const CpcaOptions& options)
    : bands_(bands), columns_(static_cast<std::size_t>(options.rank) + 1) {
  assert(bands >= 1 && bands <= kMaxMatrixBands);
  const std::size_t m = std::max<std::size_t>(sh::coefficientCount(2 * bands - 1), 1);
  assert(visibility.size() % m == 0);
  const std::vector<double> norms = matrixNorms(bands);
  std::vector<float> scale(m);
  for (std::size_t k = 0; k < m; ++k) {
    scale[k] = static_cast<float>(norms[static_cast<std::size_t>(sh::degreeOf(k))]);
  }
  std::vector<float> scaled(visibility.begin(), visibility.end());
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] *= scale[i % m];
  const Cpca cpca(scaled, m, options);
  for (std::size_t rank = 0; rank < columns_; ++rank) {
    predicted_.push_back(cpca.predictedError(rank));
  }
  measured_ = cpca.measuredError(scaled);

  for (const CpcaCluster& cluster : cpca.clusters()) {
    for (std::size_t k = 0; k < m; ++k) {
      for (std::size_t column = 0; column < columns_; ++column) {
        const float x = column == 0 ? cluster.mean[k]
                        : column <= cluster.variances.size()
                            ? cluster.components[(column - 1) * m + k]
                            : 0.0F;
        basis_.push_back(x / scale[k]);
      }
    }
  }
  // Cluster by cluster, each from the beginning of a block.
  std::vector<std::vector<std::uint32_t>> members(cpca.clusters().size());
  for (std::size_t r = 0; r < cpca.count(); ++r) {
    members[cpca.clusterOf(r)].push_back(static_cast<std::uint32_t>(r));
  }
  slot_of_.resize(cpca.count());
  for (std::size_t c = 0; c < members.size(); ++c) {
    for (std::size_t k = 0; k < members[c].size(); ++k) {
      if (k % kBlock == 0) cluster_of_block_.push_back(static_cast<std::uint32_t>(c));
      slot_of_[members[c][k]] =
          static_cast<std::uint32_t>((cluster_of_block_.size() - 1) * kBlock + k % kBlock);
    }
  }
  weights_ = HalfBlocks(cluster_of_block_.size() * kBlock, columns_);
  for (std::size_t r = 0; r < cpca.count(); ++r) {
    weights_.at(slot_of_[r], 0) = 1.0F;
    for (std::size_t j = 0; j + 1 < columns_; ++j) {
      weights_.at(slot_of_[r], j + 1) = cpca.coefficients(r)[j];
    }
  }
}

std::size_t ClusteredMatrices::bytes() const {
  return weights_.bytes() + basis_.size() * sizeof(float) +
         (cluster_of_block_.size() + slot_of_.size()) * sizeof(std::uint32_t);
}

void ClusteredMatrices::apply(const sh::RgbCoefficients& light, FloatBlocks& arriving) const {
  const std::size_t n = sh::coefficientCount(bands_);
  const std::size_t m = sh::coefficientCount(2 * bands_ - 1);
  assert(arriving.receivers() == slots() && arriving.rows() == 3 * n);
  std::vector<float> matrix;  // 3 n x m
  for (const sh::Coefficients& channel : light) {
    assert(channel.size() == n);
    for (const double f : fixedLightMatrix(channel, 2 * bands_ - 1)) {
      matrix.push_back(static_cast<float>(f));
    }
  }
  // Per cluster the light through its mean and components, 3 n x columns: columns innermost, so
  // that the compiler's vectors serve.
  const std::size_t clusters = basis_.size() / (columns_ * m);
  std::vector<float> through(clusters * 3 * n * columns_, 0.0F);
  parallelFor(clusters, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      for (std::size_t i = 0; i < 3 * n; ++i) {
        float* out = through.data() + (c * 3 * n + i) * columns_;
        for (std::size_t k = 0; k < m; ++k) {
          const float f = matrix[i * m + k];
          const float* v = basis_.data() + (c * m + k) * columns_;
          for (std::size_t column = 0; column < columns_; ++column) out[column] += f * v[column];
        }
      }
    }
  });
  parallelFor(weights_.blocks(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      multiplyBlock(through.data() + cluster_of_block_[b] * 3 * n * columns_, 3 * n, columns_,
                    weights_.block(b), arriving.block(b));
    }
  });
}

}  // namespace soffit::glossy

// SPDX-License-Identifier: MIT
#include "core/glossy/cpca.h"

#include "core/base/parallel.h"
#include "core/glossy/components.h"
#include "core/math/rng.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace soffit::glossy {
namespace {

constexpr std::size_t kCandidates = 8;
constexpr std::size_t kMeansSteps = 6;

float squaredDistance(const float* a, const float* b, std::size_t n) {
  float sum = 0.0F;
  for (std::size_t i = 0; i < n; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

/// Squared error that a cluster leaves of a vector.
float leftOver(const CpcaCluster& cluster, const float* v, std::size_t n,
               std::vector<float>& scratch) {
  scratch.resize(n);
  for (std::size_t i = 0; i < n; ++i) scratch[i] = v[i] - cluster.mean[i];
  float left = dot(scratch.data(), scratch.data(), n);
  for (std::size_t j = 0; j * n < cluster.components.size(); ++j) {
    const float c = dot(scratch.data(), cluster.components.data() + j * n, n);
    left -= c * c;
  }
  return left;
}

struct Work {
  std::span<const float> vectors;
  std::size_t n;
  std::size_t count;
  std::vector<std::vector<float>> means;
  std::vector<std::uint32_t> cluster_of;

  [[nodiscard]] const float* row(std::size_t k) const { return vectors.data() + k * n; }

  /// k-means++: the next start is drawn in proportion to its squared distance from all so far.
  void start(std::size_t clusters, std::uint64_t seed) {
    Rng rng(seed);
    std::vector<double> distance(count, std::numeric_limits<double>::infinity());
    std::size_t next = rng.below(static_cast<std::uint32_t>(count));
    while (means.size() < clusters) {
      means.emplace_back(row(next), row(next) + n);
      double sum = 0.0;
      for (std::size_t k = 0; k < count; ++k) {
        distance[k] = std::min(
            distance[k], static_cast<double>(squaredDistance(row(k), means.back().data(), n)));
        sum += distance[k];
      }
      if (!(sum > 0.0)) break;  // fewer different vectors than clusters
      double u = rng.uniformDouble() * sum;
      for (next = 0; next + 1 < count && u >= distance[next]; ++next) u -= distance[next];
    }
  }

  void assignToMeans() {
    cluster_of.resize(count);
    parallelFor(count, 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        float best = std::numeric_limits<float>::infinity();
        for (std::size_t c = 0; c < means.size(); ++c) {
          const float d = squaredDistance(row(k), means[c].data(), n);
          if (d < best) {
            best = d;
            cluster_of[k] = static_cast<std::uint32_t>(c);
          }
        }
      }
    });
  }

  [[nodiscard]] std::vector<std::vector<std::uint32_t>> members() const {
    std::vector<std::vector<std::uint32_t>> lists(means.size());
    for (std::size_t k = 0; k < count; ++k) {
      lists[cluster_of[k]].push_back(static_cast<std::uint32_t>(k));
    }
    return lists;
  }

  void moveMeans() {
    const auto lists = members();
    for (std::size_t c = 0; c < means.size(); ++c) {
      if (lists[c].empty()) continue;
      std::vector<double> sum(n, 0.0);
      for (const std::uint32_t k : lists[c]) {
        for (std::size_t i = 0; i < n; ++i) sum[i] += static_cast<double>(row(k)[i]);
      }
      for (std::size_t i = 0; i < n; ++i) {
        means[c][i] = static_cast<float>(sum[i] / static_cast<double>(lists[c].size()));
      }
    }
  }

  void assignToComponents(std::span<const CpcaCluster> clusters) {
    parallelFor(count, 64, [&](std::size_t begin, std::size_t end) {
      std::vector<std::pair<float, std::uint32_t>> near(clusters.size());
      std::vector<float> scratch;
      for (std::size_t k = begin; k < end; ++k) {
        for (std::size_t c = 0; c < clusters.size(); ++c) {
          const bool used = clusters[c].members > 0;
          near[c] = {used ? squaredDistance(row(k), clusters[c].mean.data(), n)
                          : std::numeric_limits<float>::infinity(),
                     static_cast<std::uint32_t>(c)};
        }
        const std::size_t few = std::min(kCandidates, near.size());
        std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(few),
                          near.end());
        float best = leftOver(clusters[cluster_of[k]], row(k), n, scratch);
        for (std::size_t c = 0; c < few && std::isfinite(near[c].first); ++c) {
          const float left = leftOver(clusters[near[c].second], row(k), n, scratch);
          if (left < best) {
            best = left;
            cluster_of[k] = near[c].second;
          }
        }
      }
    });
  }

  [[nodiscard]] std::vector<CpcaCluster> fit(std::size_t rank) const {
    const auto lists = members();
    std::vector<CpcaCluster> clusters(means.size());
    parallelFor(means.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) {
        clusters[c].mean = means[c];
        if (lists[c].empty()) continue;
        Components found = principalComponents(vectors, n, lists[c], rank);
        clusters[c] = {std::move(found.mean), std::move(found.rows), std::move(found.variances),
                       found.total, lists[c].size()};
      }
    });
    return clusters;
  }
};

}  // namespace

Cpca::Cpca(std::span<const float> vectors, std::size_t dimension, const CpcaOptions& options)
    : dimension_(dimension), rank_(static_cast<std::size_t>(options.rank)) {
  assert(dimension > 0 && vectors.size() % dimension == 0);
  assert(options.clusters >= 1 && options.clusters <= 65536);
  assert(options.rank >= 0 && options.rank <= 32);
  Work work{vectors, dimension, vectors.size() / dimension, {}, {}};
  if (work.count == 0) return;
  for (const float x : vectors) square_ += static_cast<double>(x) * static_cast<double>(x);
  work.start(std::min(static_cast<std::size_t>(options.clusters), work.count), options.seed);
  for (std::size_t step = 0; step < kMeansSteps; ++step) {
    work.assignToMeans();
    work.moveMeans();
  }
  work.assignToMeans();
  clusters_ = work.fit(rank_);
  for (int round = 0; round < options.rounds; ++round) {
    work.assignToComponents(clusters_);
    clusters_ = work.fit(rank_);
  }
  cluster_of_ = std::move(work.cluster_of);
  coefficients_.resize(work.count * rank_);
  parallelFor(work.count, 256, [&](std::size_t begin, std::size_t end) {
    std::vector<float> centred(dimension);
    for (std::size_t k = begin; k < end; ++k) {
      const CpcaCluster& cluster = clusters_[cluster_of_[k]];
      for (std::size_t i = 0; i < dimension; ++i) centred[i] = work.row(k)[i] - cluster.mean[i];
      for (std::size_t j = 0; j < cluster.variances.size(); ++j) {
        coefficients_[k * rank_ + j] =
            dot(centred.data(), cluster.components.data() + j * dimension, dimension);
      }
    }
  });
}

void Cpca::reconstruct(std::size_t vector, std::span<float> out) const {
  assert(out.size() == dimension_);
  const CpcaCluster& cluster = clusters_[cluster_of_[vector]];
  std::copy(cluster.mean.begin(), cluster.mean.end(), out.begin());
  for (std::size_t j = 0; j < cluster.variances.size(); ++j) {
    const float c = coefficients_[vector * rank_ + j];
    const float* row = cluster.components.data() + j * dimension_;
    for (std::size_t i = 0; i < dimension_; ++i) out[i] += c * row[i];
  }
}

std::size_t Cpca::bytes() const {
  std::size_t sum = coefficients_.size() * sizeof(transfer::Half) + cluster_of_.size() * 2;
  for (const CpcaCluster& cluster : clusters_) {
    sum += (cluster.mean.size() + cluster.components.size()) * sizeof(float);
  }
  return sum;
}

double Cpca::predictedError(std::size_t rank) const {
  if (!(square_ > 0.0)) return 0.0;
  double left = 0.0;
  for (const CpcaCluster& cluster : clusters_) {
    double kept = 0.0;
    for (std::size_t j = 0; j < std::min(rank, cluster.variances.size()); ++j) {
      kept += cluster.variances[j];
    }
    left += std::max(0.0, cluster.total - kept);
  }
  return std::sqrt(left / square_);
}

double Cpca::measuredError(std::span<const float> vectors) const {
  assert(vectors.size() == count() * dimension_);
  if (!(square_ > 0.0)) return 0.0;
  double sum = 0.0;
  std::vector<float> own(dimension_);
  for (std::size_t k = 0; k < count(); ++k) {
    reconstruct(k, own);
    sum += static_cast<double>(
        squaredDistance(own.data(), vectors.data() + k * dimension_, dimension_));
  }
  return std::sqrt(sum / square_);
}

}  // namespace soffit::glossy

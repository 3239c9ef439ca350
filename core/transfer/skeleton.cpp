// SPDX-License-Identifier: MIT
#include "core/transfer/skeleton.h"

#include "core/base/parallel.h"
#include "core/math/rng.h"
#include "core/transfer/hemisphere.h"
#include "core/transfer/kernels.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace soffit::transfer {
namespace {

using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// What one cluster contributes; put together in order afterwards.
struct ClusterResult {
  GatherLists lists;
  std::vector<float> weights;  ///< rank x slots
  std::uint32_t rank = 0;
};

class ClusterWorker {
 public:
  ClusterWorker(const StaticScene& scene, const TrainingFields& fields, const BakeSettings& settings,
                const Operators& operators, const SlotClusters& slot_clusters)
      : scene_(scene), fields_(fields), settings_(settings), operators_(operators), slot_clusters_(slot_clusters) {}

  ClusterResult work(const light::Receivers::Cluster& c) {
    const light::Receivers& r = operators_.texels.receivers;
    std::vector<std::uint32_t> points;  // slots that see light by themselves
    for (std::uint32_t s = c.begin; s < c.end; ++s) {
      if (operators_.area[s] > 0.0F) points.push_back(s);
    }
    ClusterResult result;
    if (points.empty()) return result;
    const int count = fields_.count;
    const RowMatrix y = gatherDenoised(points);
    const std::vector<Eigen::Index> pivots = choosePivots(y);
    RowMatrix ys(static_cast<Eigen::Index>(pivots.size()), count);
    ys.setZero();
    for (std::size_t k = 0; k < pivots.size(); ++k) {
      const std::uint32_t slot = points[static_cast<std::size_t>(pivots[k])];
      traceHemisphere(scene_, operators_.texels, r.position(slot), r.normal(slot), settings_.list_rays,
                      settings_.seed * 7919U + 500000003U + slot,
                      operators_.texels.gapReach(slot), scratch_, hits_);
      addFields(hits_.slots, ys.row(static_cast<Eigen::Index>(k)).data());
      result.lists.append(hits_.slots, slot_clusters_);
    }
    result.rank = static_cast<std::uint32_t>(pivots.size());
    solveWeights(c, points, y, ys, result);
    return result;
  }

 private:
  void addFields(std::span<const std::uint32_t> slots, float* row) const {
    const float share = 1.0F / static_cast<float>(slots.size());
    const auto count = static_cast<std::size_t>(fields_.count);
    for (const std::uint32_t slot : slots) {
      if (slot != kNoTexel) addScaled(share, &fields_.value[slot * count], row, count);
    }
  }

  /// Gathers the fields at points and averages each with the neighbours that receive the same
  /// light. The noise of a point's rays is known from its two halves; neighbours whose fields
  /// differ by no more than that noise are alike in all training lights at once, so real
  /// differences (contact shade, edges) survive: non-local means (Buades et al. 2005) on vectors
  /// with measured variances (after Rousselle et al. 2012).
  RowMatrix gatherDenoised(const std::vector<std::uint32_t>& points) {
    const light::Receivers& r = operators_.texels.receivers;
    const auto n = static_cast<Eigen::Index>(points.size());
    RowMatrix first = RowMatrix::Zero(n, fields_.count);
    RowMatrix second = RowMatrix::Zero(n, fields_.count);
    for (std::size_t i = 0; i < points.size(); ++i) {
      traceHemisphere(scene_, operators_.texels, r.position(points[i]), r.normal(points[i]), settings_.field_rays,
                      settings_.seed * 1000003U + points[i],
                      operators_.texels.gapReach(points[i]), scratch_, hits_);
      // Alternate strata: each half covers the whole hemisphere.
      halves_[0].clear();
      halves_[1].clear();
      for (std::size_t k = 0; k < hits_.slots.size(); ++k) halves_[(k + k / 4) % 2].push_back(hits_.slots[k]);
      addFields(halves_[0], first.row(static_cast<Eigen::Index>(i)).data());
      addFields(halves_[1], second.row(static_cast<Eigen::Index>(i)).data());
    }
    const RowMatrix y = 0.5F * (first + second);
    const Eigen::VectorXf noise = 0.25F * (first - second).rowwise().squaredNorm();
    RowMatrix smooth(n, fields_.count);
    const auto reach = static_cast<float>(4.5 * operators_.texels.cell);
    for (Eigen::Index i = 0; i < n; ++i) {
      const vec3 p = r.position(points[static_cast<std::size_t>(i)]);
      const vec3 normal = r.normal(points[static_cast<std::size_t>(i)]);
      Eigen::RowVectorXf sum = y.row(i);
      float weight = 1.0F;
      for (Eigen::Index j = 0; j < n; ++j) {
        if (j == i || glm::dot(normal, r.normal(points[static_cast<std::size_t>(j)])) < 0.9F) continue;
        const vec3 d = r.position(points[static_cast<std::size_t>(j)]) - p;
        const float d2 = glm::dot(d, d) / (reach * reach);
        if (d2 >= 1.0F) continue;
        const float expected = noise(i) + noise(j);
        const float excess = std::max(0.0F, (y.row(i) - y.row(j)).squaredNorm() - expected);
        const float w = (1.0F - d2) * std::exp(-2.0F * excess / std::max(expected, 1e-12F));
        sum += w * y.row(j);
        weight += w;
      }
      smooth.row(i) = sum / weight;
    }
    return smooth;
  }

  /// Rows that span the others, by pivoted Gram-Schmidt, until the worst residual (RMS over the
  /// fields, which have mean 1) is below the tolerance.
  std::vector<Eigen::Index> choosePivots(const RowMatrix& y) const {
    RowMatrix rest = y;
    std::vector<Eigen::Index> pivots;
    const auto limit = std::min<Eigen::Index>(settings_.max_rank, std::min(y.rows(), y.cols()));
    const double stop = settings_.tolerance * std::sqrt(static_cast<double>(y.cols()));
    while (static_cast<Eigen::Index>(pivots.size()) < limit) {
      Eigen::Index best = 0;
      const float norm = std::sqrt(rest.rowwise().squaredNorm().maxCoeff(&best));
      if (!pivots.empty() && static_cast<double>(norm) < stop) break;
      pivots.push_back(best);
      if (norm <= 0.0F) break;
      const Eigen::RowVectorXf q = rest.row(best) / norm;
      const Eigen::VectorXf along = rest * q.transpose();
      rest.noalias() -= along * q;
    }
    return pivots;
  }

  void solveWeights(const light::Receivers::Cluster& c, const std::vector<std::uint32_t>& points, const RowMatrix& y,
                    const RowMatrix& ys, ClusterResult& result) const {
    const Eigen::MatrixXd s = ys.cast<double>();
    Eigen::MatrixXd gram = s * s.transpose();
    // Noise of the gathered fields: about 1/N^(3/4) of their local size for N stratified rays.
    const double local = gram.trace() / static_cast<double>(gram.rows());
    // Twice that: a weight of 20 would carry the noise of its list 20 times.
    const double noise = 2.0 * std::pow(static_cast<double>(settings_.list_rays) * settings_.list_rays, -0.75);
    gram.diagonal().array() += std::max(local * noise * noise, 1e-12);
    const Eigen::MatrixXd w = gram.ldlt().solve(s * y.cast<double>().transpose());  // rank x points
    const std::uint32_t slots = c.end - c.begin;
    result.weights.assign(static_cast<std::size_t>(result.rank) * slots, 0.0F);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::uint32_t k = 0; k < result.rank; ++k) {
        result.weights[static_cast<std::size_t>(k) * slots + (points[i] - c.begin)] =
            static_cast<float>(w(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)));
      }
    }
  }

  const StaticScene& scene_;
  const TrainingFields& fields_;
  const BakeSettings& settings_;
  const Operators& operators_;
  const SlotClusters& slot_clusters_;
  HemisphereScratch scratch_;
  HemisphereHits hits_;
  std::array<std::vector<std::uint32_t>, 2> halves_;
};

}  // namespace

std::uint64_t fillSkeletons(const StaticScene& scene, const TrainingFields& fields, const BakeSettings& settings,
                            const Job& job, Operators& operators) {
  const auto& clusters = operators.texels.receivers.clusters;
  const SlotClusters slot_clusters = slotClusters(operators.texels.receivers);
  std::vector<ClusterResult> results(clusters.size());
  std::atomic<std::size_t> done{0};
  parallelFor(clusters.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (job.cancelled()) return;
      ClusterWorker worker(scene, fields, settings, operators, slot_clusters);
      results[i] = worker.work(clusters[i]);
      job.report("tracing gather rays", static_cast<double>(++done) / static_cast<double>(clusters.size()));
    }
  });
  std::uint64_t rays = 0;
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const ClusterResult& r = results[i];
    const std::uint32_t slots = clusters[i].end - clusters[i].begin;
    operators.clusters.push_back({static_cast<std::uint32_t>(operators.lists.lists.size()), r.rank, operators.weights.size()});
    operators.lists.append(r.lists);
    operators.weights.insert(operators.weights.end(), r.weights.begin(), r.weights.end());
    for (std::uint32_t k = 0; k < r.rank; ++k) {
      double sum = 0.0;
      for (std::uint32_t s = 0; s < slots; ++s) {
        sum += static_cast<double>(operators.area[clusters[i].begin + s]) * static_cast<double>(r.weights[k * slots + s]);
      }
      operators.list_area.push_back(static_cast<float>(sum));
    }
    rays += static_cast<std::uint64_t>(clusters[i].used) * static_cast<std::uint64_t>(settings.field_rays * settings.field_rays) +
            static_cast<std::uint64_t>(r.rank) * static_cast<std::uint64_t>(settings.list_rays * settings.list_rays);
  }
  operators.node_lists = makeNodeLists(operators.lists, operators.nodes);
  return rays;
}

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#include "core/transfer/skeleton.h"

#include "core/base/parallel.h"
#include "core/math/rng.h"
#include "core/transfer/balance.h"
#include "core/transfer/hemisphere.h"
#include "core/transfer/kernels.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

namespace soffit::transfer {
namespace {

using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The points of a cluster that take part, the fields gathered there, and which of them tell most.
struct Choice {
  std::vector<std::uint32_t> points;  ///< slots that see light by themselves
  RowMatrix y;                        ///< points x fields
  std::vector<Eigen::Index> pivots;   ///< into points, the most telling first
  /// Per pivot: the worst variance at any point before it was taken, by the root of the cluster's
  /// mean square; never rising.
  std::vector<double> left;
  Eigen::RowVectorXd arrived;  ///< per field: lux times m^2 at the points
};

/// What one cluster contributes; put together in order afterwards.
struct ClusterResult {
  GatherLists rays;   ///< texel by texel
  GatherLists lists;  ///< by blocks where those are far
  std::vector<float> weights;  ///< rank x slots
  std::uint32_t rank = 0;
  Eigen::RowVectorXf list_area;
  Eigen::RowVectorXd arrived;  ///< per field: lux times m^2 by lists and weights
};

class ClusterWorker {
 public:
  ClusterWorker(const StaticScene& scene, const TrainingFields& fields,
                const BakeSettings& settings, const Operators& operators, double mean_area)
      : scene_(scene),
        fields_(fields),
        settings_(settings),
        operators_(operators),
        mean_area_(mean_area) {}

  /// Gathers the fields at the cluster's points and puts these in the order in which they tell
  /// most.
  Choice choose(const light::Receivers::Cluster& c) {
    Choice out;
    for (std::uint32_t s = c.begin; s < c.end; ++s) {
      if (operators_.area[s] > 0.0F) out.points.push_back(s);
    }
    if (out.points.empty()) return out;
    out.y = gatherDenoised(out.points, out.arrived);
    orderPivots(covariance(out.points, out.y), out);
    return out;
  }

  /// Traces the lists of the first `rank` pivots and fits the weights.
  ClusterResult work(const light::Receivers::Cluster& c, const Choice& choice, std::size_t rank) {
    const light::Receivers& r = operators_.texels.receivers;
    ClusterResult result;
    if (choice.points.empty()) return result;
    const std::span<const Eigen::Index> pivots(choice.pivots.data(), rank);
    RowMatrix ys(static_cast<Eigen::Index>(rank), fields_.count);
    ys.setZero();
    for (std::size_t k = 0; k < rank; ++k) {
      const std::uint32_t slot = choice.points[static_cast<std::size_t>(pivots[k])];
      traceHemisphere(scene_, operators_.texels, r.position(slot), r.normal(slot),
                      settings_.list_rays, settings_.seed * 7919U + 500000003U + slot,
                      operators_.texels.gapReach(slot), scratch_, hits_);
      result.rays.append(hits_.slots);
      stepBack(slot, hits_.slots);
      addFields(hits_.slots, ys.row(static_cast<Eigen::Index>(k)).data());
      result.lists.append(hits_.slots);
    }
    result.rank = static_cast<std::uint32_t>(rank);
    solveWeights(c, choice.points, pivots, choice.y, ys, result);
    result.list_area = listAreas(c, result);
    result.arrived = result.list_area.cast<double>() * ys.cast<double>();
    return result;
  }

 private:
  void stepBack(std::uint32_t slot, std::span<std::uint32_t> ends) const {
    const light::Receivers& r = operators_.texels.receivers;
    fields_.blocks.stepBack(operators_.texels, r.position(slot), r.normal(slot),
                            1.0F / static_cast<float>(ends.size()), ends);
  }

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
  RowMatrix gatherDenoised(const std::vector<std::uint32_t>& points, Eigen::RowVectorXd& arrived) {
    const light::Receivers& r = operators_.texels.receivers;
    const auto n = static_cast<Eigen::Index>(points.size());
    RowMatrix first = RowMatrix::Zero(n, fields_.count);
    RowMatrix second = RowMatrix::Zero(n, fields_.count);
    for (std::size_t i = 0; i < points.size(); ++i) {
      traceHemisphere(scene_, operators_.texels, r.position(points[i]), r.normal(points[i]),
                      settings_.field_rays, settings_.seed * 1000003U + points[i],
                      operators_.texels.gapReach(points[i]), scratch_, hits_);
      // Alternate strata: each half covers the whole hemisphere.
      halves_[0].clear();
      halves_[1].clear();
      for (std::size_t k = 0; k < hits_.slots.size(); ++k)
        halves_[(k + k / 4) % 2].push_back(hits_.slots[k]);
      addFields(halves_[0], first.row(static_cast<Eigen::Index>(i)).data());
      addFields(halves_[1], second.row(static_cast<Eigen::Index>(i)).data());
    }
    const RowMatrix y = 0.5F * (first + second);
    arrived = Eigen::RowVectorXd::Zero(fields_.count);
    for (Eigen::Index i = 0; i < n; ++i) {
      arrived += static_cast<double>(operators_.area[points[static_cast<std::size_t>(i)]]) *
                 y.row(i).cast<double>();
    }
    const Eigen::VectorXf noise = 0.25F * (first - second).rowwise().squaredNorm();
    RowMatrix smooth(n, fields_.count);
    const auto reach = static_cast<float>(4.5 * operators_.texels.cell);
    for (Eigen::Index i = 0; i < n; ++i) {
      const vec3 p = r.position(points[static_cast<std::size_t>(i)]);
      const vec3 normal = r.normal(points[static_cast<std::size_t>(i)]);
      Eigen::RowVectorXf sum = y.row(i);
      float weight = 1.0F;
      for (Eigen::Index j = 0; j < n; ++j) {
        if (j == i || glm::dot(normal, r.normal(points[static_cast<std::size_t>(j)])) < 0.9F)
          continue;
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

  /// Covariance of the light at points: what the training lights show, and light that they do not
  /// show, which may differ as the square root of the distance (a lamp beside a bed lights the
  /// wall in a way that no light drawn at random does).
  [[nodiscard]] Eigen::MatrixXd covariance(const std::vector<std::uint32_t>& points,
                                           const RowMatrix& y) const {
    Eigen::MatrixXd c = (y * y.transpose()).cast<double>();
    const Eigen::VectorXd level = untrainedLevels(c.diagonal(), 1.0);
    for (Eigen::Index i = 0; i < c.rows(); ++i) {
      for (Eigen::Index j = 0; j < c.cols(); ++j) {
        c(i, j) += level(i) * level(j) * nearness(points[static_cast<std::size_t>(i)],
                                                  points[static_cast<std::size_t>(j)]);
      }
    }
    return c;
  }

  /// Root of the untrained variance at points whose trained one is `squares`: the cluster's mean
  /// of it where pivots are chosen (`even` 1), so that the dark is looked at, too; mostly their own
  /// where weights are fitted, or the dark would borrow from bright neighbours.
  static Eigen::VectorXd untrainedLevels(const Eigen::VectorXd& squares, double even) {
    return (kUntrained * ((1.0 - even) * squares.array() + even * squares.mean())).sqrt();
  }

  /// Correlation of light that training does not show. An exponential has no memory beyond the
  /// nearest points (it is a Markov kernel: Rasmussen & Williams 2006, 4.2.1), so weights that
  /// follow from it stay between 0 and 1.
  [[nodiscard]] double nearness(std::uint32_t a, std::uint32_t b) const {
    const light::Receivers& r = operators_.texels.receivers;
    const vec3 apart = r.position(a) - r.position(b);
    const vec3 turned = r.normal(a) - r.normal(b);
    const double reach = kUntrainedReach * operators_.texels.cell;
    return std::exp(-std::sqrt(static_cast<double>(glm::dot(apart, apart)) / (reach * reach) +
                               static_cast<double>(glm::dot(turned, turned))));
  }

  /// Of a texel of the cluster, by that of all texels.
  [[nodiscard]] double meanArea(std::span<const std::uint32_t> points) const {
    double own = 0.0;
    for (const std::uint32_t s : points) own += static_cast<double>(operators_.area[s]);
    return own / static_cast<double>(points.size()) / mean_area_;
  }

  /// Points from which the others follow, by pivoted Cholesky (Harbrecht, Peters, Schneider 2012).
  void orderPivots(const Eigen::MatrixXd& c, Choice& out) const {
    Eigen::VectorXd left = c.diagonal();
    std::vector<Eigen::VectorXd> columns;
    const auto limit = std::min<Eigen::Index>(settings_.max_rank, c.rows());
    // The same error counts for more where it is darker, though not in proportion; and by the area
    // it is made on: a smooth ceiling needs few lists, but with too few of them it carried the
    // error of 40 % of all reflected light (1.2 % too little in the office, 0.4 % so), while
    // furniture of small texels took the lists.
    const double level = std::sqrt(c.trace() / static_cast<double>(c.rows() * fields_.count));
    const double scale =
        meanArea(out.points) / std::max(level * static_cast<double>(fields_.count), 1e-12);
    while (static_cast<Eigen::Index>(out.pivots.size()) < limit) {
      Eigen::Index best = 0;
      const double variance = left.maxCoeff(&best);
      if (!out.pivots.empty() && variance <= 0.0) break;
      out.pivots.push_back(best);
      out.left.push_back(out.left.empty() ? 1e300 : std::min(out.left.back(), variance * scale));
      if (variance <= 0.0) break;
      Eigen::VectorXd column = c.col(best);
      for (const Eigen::VectorXd& earlier : columns) column -= earlier(best) * earlier;
      column /= std::sqrt(variance);
      left -= column.cwiseAbs2();
      columns.push_back(std::move(column));
    }
  }

  /// W = C_xs (C_ss + lambda)^-1, with the fields of the skeleton's own lists in C_ss.
  void solveWeights(const light::Receivers::Cluster& c, const std::vector<std::uint32_t>& points,
                    std::span<const Eigen::Index> pivots, const RowMatrix& y, const RowMatrix& ys,
                    ClusterResult& result) const {
    const Eigen::MatrixXd s = ys.cast<double>();
    Eigen::MatrixXd gram = s * s.transpose();
    Eigen::MatrixXd to_points = s * y.cast<double>().transpose();  // rank x points
    // Noise of the gathered fields: about 1/N^(3/4) of their local size for N stratified rays.
    const double local = gram.trace() / static_cast<double>(gram.rows());
    const Eigen::VectorXd level = untrainedLevels(y.cast<double>().rowwise().squaredNorm(), kEvenWeights);
    // Twice that: a weight of 20 would carry the noise of its list 20 times.
    const double noise =
        2.0 * std::pow(static_cast<double>(settings_.list_rays) * settings_.list_rays, -0.75);
    for (Eigen::Index k = 0; k < gram.rows(); ++k) {
      const std::uint32_t of =
          points[static_cast<std::size_t>(pivots[static_cast<std::size_t>(k)])];
      for (std::size_t i = 0; i < points.size(); ++i) {
        to_points(k, static_cast<Eigen::Index>(i)) += level(pivots[static_cast<std::size_t>(k)]) * level(static_cast<Eigen::Index>(i)) * nearness(of, points[i]);
      }
      for (Eigen::Index j = 0; j < gram.cols(); ++j) {
        const std::uint32_t other =
            points[static_cast<std::size_t>(pivots[static_cast<std::size_t>(j)])];
        gram(k, j) += level(pivots[static_cast<std::size_t>(k)]) * level(pivots[static_cast<std::size_t>(j)]) * nearness(of, other);
      }
    }
    gram.diagonal().array() += std::max(local * noise * noise, 1e-12);
    const Eigen::MatrixXd w = gram.ldlt().solve(to_points);
    const std::uint32_t slots = c.end - c.begin;
    result.weights.assign(static_cast<std::size_t>(result.rank) * slots, 0.0F);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::uint32_t k = 0; k < result.rank; ++k) {
        result.weights[static_cast<std::size_t>(k) * slots + (points[i] - c.begin)] =
            static_cast<float>(w(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)));
      }
    }
  }

  /// Per list: area times weight, summed over the cluster's slots.
  [[nodiscard]] Eigen::RowVectorXf listAreas(const light::Receivers::Cluster& c,
                                             const ClusterResult& result) const {
    const std::uint32_t slots = c.end - c.begin;
    Eigen::RowVectorXf out(static_cast<Eigen::Index>(result.rank));
    for (std::uint32_t k = 0; k < result.rank; ++k) {
      double sum = 0.0;
      for (std::uint32_t s = 0; s < slots; ++s) {
        sum += static_cast<double>(operators_.area[c.begin + s]) *
               static_cast<double>(result.weights[k * slots + s]);
      }
      out(static_cast<Eigen::Index>(k)) = static_cast<float>(sum);
    }
    return out;
  }

  /// Share of the variance that is not the training's, and the distance (in cells) over which it
  /// falls to 1/e. With 0.03 instead of 0.01 the office's work planes are 0.01 % darker; with 0.004
  /// surfaces in flat go from a P95 of 17.0 to 17.7 %.
  static constexpr double kUntrained = 0.01;
  static constexpr double kUntrainedReach = 8.0;
  /// Between 1 (in the office int/gathered sums 0.5 % high, P95 on surfaces 40.9 %) and 0 (0.3 %,
  /// 37.2 %, but the bedside lamp alone from 56 to 65 %).
  static constexpr double kEvenWeights = 0.3;

  const StaticScene& scene_;
  const TrainingFields& fields_;
  const BakeSettings& settings_;
  const Operators& operators_;
  double mean_area_;  ///< m^2 of a texel
  HemisphereScratch scratch_;
  HemisphereHits hits_;
  std::array<std::vector<std::uint32_t>, 2> halves_;
};

/// How many pivots of each cluster are worth a list: all that stand for more variance than a limit
/// that leaves the wished number, or than the tolerance.
std::vector<std::size_t> chooseRanks(std::span<const Choice> choices, std::size_t most,
                                     double tolerance) {
  std::vector<double> left;
  for (const Choice& c : choices) left.insert(left.end(), c.left.begin(), c.left.end());
  double limit = tolerance * tolerance;
  if (left.size() > most) {
    const auto nth = left.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(left.begin(), nth, left.end(), std::greater<>());
    limit = std::max(limit, *nth);
  }
  std::vector<std::size_t> ranks;
  for (const Choice& c : choices) {
    const auto worth =
        std::find_if(c.left.begin(), c.left.end(), [&](double l) { return l <= limit; });
    ranks.push_back(static_cast<std::size_t>(worth - c.left.begin()));
  }
  return ranks;
}

/// Texels that take no part show the light of others, and rays meet them at the edges of what
/// covers them: what arrives from there was sent, too.
void countUnheard(const GatherLists& lists, Operators& operators) {
  for (std::size_t k = 0; k < lists.lists.size(); ++k) {
    const float worth = operators.list_area[k] * lists.lists[k].scale;
    lists.forEachEntry(lists.lists[k], [&](std::uint32_t slot, std::uint32_t rays) {
      if (operators.area[slot] <= 0.0F) {
        operators.sends[slot] += worth * static_cast<float>(rays);
      }
    });
  }
}

}  // namespace

std::uint64_t fillSkeletons(const StaticScene& scene, const TrainingFields& fields,
                            const BakeSettings& settings, const Job& job, Operators& operators) {
  const auto& clusters = operators.texels.receivers.clusters;
  const double mean_area =
      std::max(std::accumulate(operators.area.begin(), operators.area.end(), 0.0), 1e-30) /
      static_cast<double>(operators.texels.texelCount());
  std::vector<Choice> choices(clusters.size());
  std::vector<ClusterResult> results(clusters.size());
  std::atomic<std::size_t> done{0};
  parallelFor(clusters.size(), 1, [&](std::size_t begin, std::size_t end) {
    ClusterWorker worker(scene, fields, settings, operators, mean_area);
    for (std::size_t i = begin; i < end; ++i) {
      if (job.cancelled()) return;
      choices[i] = worker.choose(clusters[i]);
      job.report("looking where light differs",
                 static_cast<double>(++done) / static_cast<double>(clusters.size()));
    }
  });
  Eigen::RowVectorXd arrived = Eigen::RowVectorXd::Zero(fields.count);
  for (const Choice& c : choices) {
    if (!c.points.empty()) arrived += c.arrived;
  }
  const std::vector<std::size_t> ranks = chooseRanks(
      choices,
      static_cast<std::size_t>(settings.lists * static_cast<double>(operators.texels.texelCount())),
      settings.tolerance);
  done = 0;
  parallelFor(clusters.size(), 1, [&](std::size_t begin, std::size_t end) {
    ClusterWorker worker(scene, fields, settings, operators, mean_area);
    for (std::size_t i = begin; i < end; ++i) {
      if (job.cancelled()) return;
      results[i] = worker.work(clusters[i], choices[i], ranks[i]);
      choices[i] = {};
      job.report("tracing gather rays",
                 static_cast<double>(++done) / static_cast<double>(clusters.size()));
    }
  });
  std::uint64_t rays = 0;
  GatherLists by_texel;
  Eigen::RowVectorXd interpolated = Eigen::RowVectorXd::Zero(fields.count);
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const ClusterResult& r = results[i];
    operators.clusters.push_back({static_cast<std::uint32_t>(operators.lists.lists.size()), r.rank,
                                  operators.weights.size()});
    by_texel.append(r.rays);
    operators.lists.append(r.lists);
    operators.weights.insert(operators.weights.end(), r.weights.begin(), r.weights.end());
    operators.list_area.insert(operators.list_area.end(), r.list_area.begin(), r.list_area.end());
    if (r.rank > 0) interpolated += r.arrived;
    rays += static_cast<std::uint64_t>(clusters[i].used) *
                static_cast<std::uint64_t>(settings.field_rays * settings.field_rays) +
            static_cast<std::uint64_t>(r.rank) *
                static_cast<std::uint64_t>(settings.list_rays * settings.list_rays);
  }
  countUnheard(by_texel, operators);
  operators.conserve = trustInConservation(
      fields, {arrived.data(), static_cast<std::size_t>(arrived.size())},
      {interpolated.data(), static_cast<std::size_t>(interpolated.size())}, operators);
  operators.node_lists = makeNodeLists(by_texel, operators.nodes);
  return rays;
}

}  // namespace soffit::transfer

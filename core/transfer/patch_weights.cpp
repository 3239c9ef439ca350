// SPDX-License-Identifier: MIT
#include "core/transfer/patch_weights.h"

#include "core/base/parallel.h"

#include <Eigen/Dense>

namespace soffit::transfer {
namespace {

using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// area rho phi / A of a patch's slots: three functions for each of three channels.
RowMatrix sending(const Operators& op, const Nodes::Patch& p,
                  const std::array<std::span<const float>, 3>& rho) {
  const auto slots = static_cast<Eigen::Index>(p.end - p.begin);
  RowMatrix out = RowMatrix::Zero(9, slots);
  if (p.area <= 0.0) return out;
  for (std::uint32_t s = p.begin; s < p.end; ++s) {
    const vec3 phi(1.0F, op.nodes.phi[s].x, op.nodes.phi[s].y);
    for (int c = 0; c < 3; ++c) {
      const float sent =
          op.area[s] * rho[static_cast<std::size_t>(c)][s] / static_cast<float>(p.area);
      for (int a = 0; a < 3; ++a)
        out(3 * c + a, static_cast<Eigen::Index>(s - p.begin)) = sent * phi[a];
    }
  }
  return out;
}

/// The weights of a cluster's skeleton points at a patch's slots.
RowMatrix weightsAt(const Operators& op, std::size_t cluster, const Nodes::Patch& p) {
  const light::Receivers::Cluster& c = op.texels.receivers.clusters[cluster];
  const ClusterWeights& cw = op.clusters[cluster];
  RowMatrix out(cw.rank, static_cast<Eigen::Index>(p.end - p.begin));
  for (std::uint32_t k = 0; k < cw.rank; ++k) {
    const Half* row =
        &op.weights[cw.first_weight + k * std::size_t{c.end - c.begin} + (p.begin - c.begin)];
    for (Eigen::Index s = 0; s < out.cols(); ++s) out(k, s) = row[s];
  }
  return out;
}

}  // namespace

PatchWeights makePatchWeights(const Operators& op,
                              const std::array<std::span<const float>, 3>& rho) {
  PatchWeights out;
  std::vector<std::size_t> cluster_of;
  std::size_t total = 0;
  for (const Nodes::Patch& p : op.nodes.patches) {
    std::size_t cluster = cluster_of.empty() ? 0 : cluster_of.back();
    while (op.texels.receivers.clusters[cluster].end <= p.begin) ++cluster;
    cluster_of.push_back(cluster);
    out.first.push_back(total);
    total += op.clusters[cluster].rank;
  }
  out.value.resize(total);
  parallelFor(cluster_of.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Nodes::Patch& p = op.nodes.patches[i];
      const RowMatrix w = weightsAt(op, cluster_of[i], p);
      if (w.rows() == 0) continue;
      const RowMatrix product = w * sending(op, p, rho).transpose();
      for (Eigen::Index k = 0; k < product.rows(); ++k) {
        std::array<vec4, 3>& value = out.value[out.first[i] + static_cast<std::size_t>(k)];
        for (int a = 0; a < 3; ++a) {
          value[static_cast<std::size_t>(a)] =
              vec4(product(k, a), product(k, 3 + a), product(k, 6 + a), 0.0F);
        }
      }
    }
  });
  return out;
}

PatchLight sentOn(const PatchWeights& weights, std::size_t patch, std::span<const vec4> y) {
  PatchLight out;
  const std::array<vec4, 3>* value = weights.value.data() + weights.first[patch];
  for (const vec4& light : y) {
    for (std::size_t a = 0; a < 3; ++a) out.c[a] += (*value)[a] * light;
    ++value;
  }
  return out;
}

}  // namespace soffit::transfer

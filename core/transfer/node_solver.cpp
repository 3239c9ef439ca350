// SPDX-License-Identifier: MIT
#include "core/transfer/node_solver.h"

#include "core/base/parallel.h"
#include "core/transfer/kernels.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>

namespace soffit::transfer {

namespace {

/// One channel's reflectances, and the factors of its tail.
struct Channel {
  /// Per patch the symmetric 3 x 3 M_ab = 1/A sum A rho phi_a phi_b: 00, 01, 02, 11, 12, 22.
  std::vector<std::array<float, 6>> reflect;
  Eigen::PartialPivLU<Eigen::MatrixXf> factor;
  bool dark = true;  // nothing reflects
};

void setReflectance(const Nodes& nodes, std::span<const float> area, std::span<const float> reflectance,
                    Channel& channel) {
  channel.reflect.resize(nodes.patches.size());
  for (std::size_t i = 0; i < nodes.patches.size(); ++i) {
    const Nodes::Patch& p = nodes.patches[i];
    std::array<double, 6> m{};
    for (std::uint32_t s = p.begin; s < p.end; ++s) {
      const double w = static_cast<double>(area[s]) * static_cast<double>(reflectance[s]);
      const double x = static_cast<double>(nodes.phi[s].x);
      const double y = static_cast<double>(nodes.phi[s].y);
      m[0] += w;
      m[1] += w * x;
      m[2] += w * y;
      m[3] += w * x * x;
      m[4] += w * x * y;
      m[5] += w * y * y;
    }
    for (std::size_t k = 0; k < 6; ++k) {
      channel.reflect[i][k] = p.area > 0.0 ? static_cast<float>(m[k] / p.area) : 0.0F;
    }
    if (channel.reflect[i][0] > 0.0F) channel.dark = false;
  }
}

/// b = M e.
void reflectInto(const Nodes& nodes, const Channel& channel, std::span<const float> e, std::span<float> b) {
  for (std::size_t i = 0; i < nodes.patches.size(); ++i) {
    const Nodes::Patch& p = nodes.patches[i];
    const auto& m = channel.reflect[i];
    const float e0 = e[p.first];
    const float e1 = p.count > 1 ? e[p.first + 1] : 0.0F;
    const float e2 = p.count > 2 ? e[p.first + 2] : 0.0F;
    b[p.first] = m[0] * e0 + m[1] * e1 + m[2] * e2;
    if (p.count > 1) b[p.first + 1] = m[1] * e0 + m[3] * e1 + m[4] * e2;
    if (p.count > 2) b[p.first + 2] = m[2] * e0 + m[4] * e1 + m[5] * e2;
  }
}

/// y = F x for all channels, the matrix read once.
void multiply(const Nodes& nodes, const NodeSolver::Vectors& x, NodeSolver::Vectors& y) {
  std::vector<const float*> from;
  std::vector<float*> to;
  for (std::size_t c = 0; c < x.size(); ++c) {
    y[c].resize(nodes.stride, 0.0F);
    from.push_back(x[c].data());
    to.push_back(y[c].data());
  }
  multiplyRows(nodes.matrix, nodes.stride, nodes.functions, from, to);
}

}  // namespace

struct NodeSolver::Impl {
  const Nodes* nodes = nullptr;
  Eigen::MatrixXf constants;  // F_c, patches x patches
  std::vector<Channel> channels;

  /// e += the rest of the series, from the radiosity that is still to be sent.
  void addTail(const Channel& channel, std::span<const float> b, std::span<float> e) const {
    const auto count = static_cast<Eigen::Index>(nodes->patches.size());
    Eigen::VectorXf sent(count);
    for (Eigen::Index i = 0; i < count; ++i) sent(i) = b[nodes->patches[static_cast<std::size_t>(i)].first];
    const Eigen::VectorXf tail = channel.factor.solve(constants * sent);
    for (Eigen::Index i = 0; i < count; ++i) e[nodes->patches[static_cast<std::size_t>(i)].first] += tail(i);
  }
};

NodeSolver::NodeSolver(const Nodes& nodes, std::span<const float> area,
                       std::span<const std::span<const float>> reflectance)
    : impl_(std::make_unique<Impl>()) {
  impl_->nodes = &nodes;
  impl_->channels.resize(reflectance.size());
  const auto count = static_cast<Eigen::Index>(nodes.patches.size());
  impl_->constants.resize(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const float* row = &nodes.matrix[nodes.patches[static_cast<std::size_t>(i)].first * nodes.stride];
    for (Eigen::Index j = 0; j < count; ++j) {
      impl_->constants(i, j) = row[nodes.patches[static_cast<std::size_t>(j)].first];
    }
  }
  parallelFor(reflectance.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      Channel& channel = impl_->channels[c];
      setReflectance(nodes, area, reflectance[c], channel);
      if (channel.dark) continue;
      // e = F_c b3 + F_c M_c e  =>  (I - F_c M_c) e = F_c b3.
      Eigen::MatrixXf system(count, count);
      for (Eigen::Index j = 0; j < count; ++j) {
        system.col(j) = -channel.reflect[static_cast<std::size_t>(j)][0] * impl_->constants.col(j);
        system(j, j) += 1.0F;
      }
      channel.factor.compute(system);
    }
  });
}

NodeSolver::~NodeSolver() = default;
NodeSolver::NodeSolver(NodeSolver&&) noexcept = default;
NodeSolver& NodeSolver::operator=(NodeSolver&&) noexcept = default;

void NodeSolver::solve(const Vectors& b0, Vectors& indirect) const {
  const Nodes& nodes = *impl_->nodes;
  const std::size_t channels = impl_->channels.size();
  Vectors e2(channels);
  Vectors b(channels, std::vector<float>(nodes.stride, 0.0F));
  indirect.resize(channels);
  multiply(nodes, b0, indirect);
  for (std::size_t c = 0; c < channels; ++c) reflectInto(nodes, impl_->channels[c], indirect[c], b[c]);
  multiply(nodes, b, e2);
  parallelFor(channels, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const Channel& channel = impl_->channels[c];
      if (channel.dark) {
        std::fill(indirect[c].begin(), indirect[c].end(), 0.0F);
        continue;
      }
      reflectInto(nodes, channel, e2[c], b[c]);
      for (std::size_t f = 0; f < nodes.functions; ++f) indirect[c][f] += e2[c][f];
      impl_->addTail(channel, b[c], indirect[c]);
    }
  });
}

void NodeSolver::reflect(std::size_t channel, std::span<const float> irradiance, std::span<float> radiosity) const {
  reflectInto(*impl_->nodes, impl_->channels[channel], irradiance, radiosity);
}

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#include "core/transfer/node_solver.h"

#include "core/transfer/kernels.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>

namespace soffit::transfer {

struct NodeSolver::Impl {
  const Nodes* nodes = nullptr;
  /// Per patch the symmetric 3 x 3 M_ab = 1/A sum A rho phi_a phi_b: 00, 01, 02, 11, 12, 22.
  std::vector<std::array<float, 6>> reflect;
  Eigen::MatrixXf constants;  // F_c, patches x patches
  Eigen::PartialPivLU<Eigen::MatrixXf> factor;
  bool dark = true;  // nothing reflects

  /// b = M e.
  void reflectInto(std::span<const float> e, std::span<float> b) const {
    for (std::size_t i = 0; i < nodes->patches.size(); ++i) {
      const Nodes::Patch& p = nodes->patches[i];
      const auto& m = reflect[i];
      const float e0 = e[p.first];
      const float e1 = p.count > 1 ? e[p.first + 1] : 0.0F;
      const float e2 = p.count > 2 ? e[p.first + 2] : 0.0F;
      b[p.first] = m[0] * e0 + m[1] * e1 + m[2] * e2;
      if (p.count > 1) b[p.first + 1] = m[1] * e0 + m[3] * e1 + m[4] * e2;
      if (p.count > 2) b[p.first + 2] = m[2] * e0 + m[4] * e1 + m[5] * e2;
    }
  }
};

NodeSolver::NodeSolver(const Nodes& nodes, std::span<const float> area, std::span<const float> reflectance)
    : impl_(std::make_unique<Impl>()) {
  impl_->nodes = &nodes;
  impl_->reflect.resize(nodes.patches.size());
  const auto count = static_cast<Eigen::Index>(nodes.patches.size());
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
      impl_->reflect[i][k] = p.area > 0.0 ? static_cast<float>(m[k] / p.area) : 0.0F;
    }
    if (impl_->reflect[i][0] > 0.0F) impl_->dark = false;
  }
  if (impl_->dark) return;
  impl_->constants.resize(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const float* row = &nodes.matrix[nodes.patches[static_cast<std::size_t>(i)].first * nodes.stride];
    for (Eigen::Index j = 0; j < count; ++j) {
      impl_->constants(i, j) = row[nodes.patches[static_cast<std::size_t>(j)].first];
    }
  }
  // e = F_c b3 + F_c M_c e  =>  (I - F_c M_c) e = F_c b3.
  Eigen::MatrixXf system(count, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    system.col(j) = -impl_->reflect[static_cast<std::size_t>(j)][0] * impl_->constants.col(j);
    system(j, j) += 1.0F;
  }
  impl_->factor.compute(system);
}

NodeSolver::~NodeSolver() = default;
NodeSolver::NodeSolver(NodeSolver&&) noexcept = default;
NodeSolver& NodeSolver::operator=(NodeSolver&&) noexcept = default;

void NodeSolver::solve(std::span<const float> b0, std::span<float> indirect) const {
  const Nodes& nodes = *impl_->nodes;
  if (impl_->dark) {
    std::fill(indirect.begin(), indirect.end(), 0.0F);
    return;
  }
  std::vector<float> e1(nodes.stride, 0.0F);
  std::vector<float> b1(nodes.stride, 0.0F);
  std::vector<float> e2(nodes.stride, 0.0F);
  multiplyNodeMatrix(nodes, b0, e1);
  impl_->reflectInto(e1, b1);
  multiplyNodeMatrix(nodes, b1, e2);
  impl_->reflectInto(e2, b1);
  const auto count = static_cast<Eigen::Index>(nodes.patches.size());
  Eigen::VectorXf b3(count);
  for (Eigen::Index i = 0; i < count; ++i) b3(i) = b1[nodes.patches[static_cast<std::size_t>(i)].first];
  const Eigen::VectorXf tail = impl_->factor.solve(impl_->constants * b3);
  for (std::size_t f = 0; f < nodes.functions; ++f) indirect[f] = e1[f] + e2[f];
  for (Eigen::Index i = 0; i < count; ++i) indirect[nodes.patches[static_cast<std::size_t>(i)].first] += tail(i);
}

void NodeSolver::reflect(std::span<const float> irradiance, std::span<float> radiosity) const {
  impl_->reflectInto(irradiance, radiosity);
}

void multiplyNodeMatrix(const Nodes& nodes, std::span<const float> x, std::span<float> y) {
  multiplyRows(nodes.matrix, nodes.stride, nodes.functions, x, y);
}

}  // namespace soffit::transfer

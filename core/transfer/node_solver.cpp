// SPDX-License-Identifier: MIT
#include "core/transfer/node_solver.h"

#include "core/transfer/linear_solver.h"

#include <algorithm>

namespace soffit::transfer {
namespace {

/// Residual of the tail, of its first bounce. What is left of all light is less than that whatever
/// reflects: the factor 1 / (1 - rho) by which residuals grow is the one by which light does.
constexpr double kTolerance = 3e-5;

std::array<float, 6> reflectanceOf(const Nodes& nodes, const Nodes::Patch& p,
                                   std::span<const float> area,
                                   std::span<const float> reflectance) {
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
  std::array<float, 6> out{};
  for (std::size_t k = 0; k < 6 && p.area > 0.0; ++k) out[k] = static_cast<float>(m[k] / p.area);
  return out;
}

}  // namespace

NodeSolver::NodeSolver(const Nodes& nodes, std::span<const float> area,
                       std::span<const std::span<const float>> reflectance)
    : nodes_(&nodes), constants_(constantsOf(nodes.matrix)) {
  reflect_.assign(nodes.patches.size(), {});
  for (std::size_t i = 0; i < nodes.patches.size(); ++i) {
    for (std::size_t k = 0; k < 6; ++k) reflect_[i][k] = vec4(0.0F);
    for (int c = 0; c < static_cast<int>(reflectance.size()); ++c) {
      const auto m = reflectanceOf(nodes, nodes.patches[i], area,
                                   reflectance[static_cast<std::size_t>(c)]);
      for (std::size_t k = 0; k < 6; ++k) reflect_[i][k][c] = m[k];
      if (m[0] > 0.0F) bright_[c] = 1.0F;
    }
    reflect_constant_.push_back(reflect_[i][0]);
  }
}

void NodeSolver::addTail(std::span<const PatchLight> b, std::span<PatchLight> e) const {
  const std::size_t count = b.size();
  std::vector<vec4> sent(count);
  std::vector<vec4> first(count);
  std::vector<vec4> tail(count);
  for (std::size_t i = 0; i < count; ++i) sent[i] = b[i].c[0];
  multiplyConstants(constants_, sent, first);
  solveLanes(
      [&](std::span<const vec4> x, std::span<vec4> y) {
        for (std::size_t i = 0; i < count; ++i) sent[i] = reflect_constant_[i] * x[i];
        multiplyConstants(constants_, sent, y);
      },
      first, tail, kTolerance);
  for (std::size_t i = 0; i < count; ++i) e[i].c[0] += tail[i];
}

void NodeSolver::solve(std::span<const PatchLight> b0, std::span<PatchLight> indirect) const {
  std::vector<PatchLight> b(b0.size());
  std::vector<PatchLight> e2(b0.size());
  multiplyNodes(nodes_->matrix, b0, indirect);
  reflect(indirect, b);
  multiplyNodes(nodes_->matrix, b, e2);
  reflect(e2, b);
  for (std::size_t i = 0; i < e2.size(); ++i) {
    for (std::size_t a = 0; a < 3; ++a) {
      indirect[i].c[a] = bright_ * (indirect[i].c[a] + e2[i].c[a]);
    }
  }
  addTail(b, indirect);
}

void NodeSolver::solve(const Vectors& b0, Vectors& indirect) const {
  const std::vector<PatchLight> b = toPatches(*nodes_, b0);
  std::vector<PatchLight> e(b.size());
  solve(b, e);
  indirect.resize(b0.size());
  fromPatches(*nodes_, e, indirect);
}

void NodeSolver::reflect(std::span<const PatchLight> irradiance,
                         std::span<PatchLight> radiosity) const {
  for (std::size_t i = 0; i < irradiance.size(); ++i) {
    const auto& m = reflect_[i];
    const auto& e = irradiance[i].c;
    auto& b = radiosity[i].c;
    b[0] = m[0] * e[0] + m[1] * e[1] + m[2] * e[2];
    b[1] = m[1] * e[0] + m[3] * e[1] + m[4] * e[2];
    b[2] = m[2] * e[0] + m[4] * e[1] + m[5] * e[2];
  }
}

std::vector<PatchLight> toPatches(const Nodes& nodes, const NodeSolver::Vectors& coefficients) {
  std::vector<PatchLight> out(nodes.patches.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Nodes::Patch& p = nodes.patches[i];
    for (int c = 0; c < static_cast<int>(coefficients.size()); ++c) {
      const std::vector<float>& from = coefficients[static_cast<std::size_t>(c)];
      for (std::size_t a = 0; a < p.count; ++a) out[i].c[a][c] = from[p.first + a];
    }
  }
  return out;
}

void fromPatches(const Nodes& nodes, std::span<const PatchLight> patches,
                 NodeSolver::Vectors& coefficients) {
  for (int c = 0; c < static_cast<int>(coefficients.size()); ++c) {
    std::vector<float>& to = coefficients[static_cast<std::size_t>(c)];
    to.assign(nodes.stride, 0.0F);
    for (std::size_t i = 0; i < patches.size(); ++i) {
      const Nodes::Patch& p = nodes.patches[i];
      for (std::size_t a = 0; a < p.count; ++a) to[p.first + a] = patches[i].c[a][c];
    }
  }
}

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#include "core/relight/solver.h"

#include "core/base/parallel.h"
#include "core/transfer/kernels.h"

#include <algorithm>
#include <chrono>

namespace soffit::relight {
namespace {

class Lap {
 public:
  double ms() {
    const auto now = std::chrono::steady_clock::now();
    const double passed = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return passed;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

Solver::Solver(std::shared_ptr<const transfer::StaticScene> scene, std::shared_ptr<const transfer::Operators> operators,
               std::span<const scene::Material> materials)
    : scene_(std::move(scene)), operators_(std::move(operators)) {
  setMaterials(materials);
  for (std::uint32_t s = 0; s < operators_->fill_from.size(); ++s) {
    if (operators_->fill_from[s] != s) filled_.push_back(s);
  }
}

void Solver::setMaterials(std::span<const scene::Material> materials) {
  reflectances_ = makeReflectances(operators_->texels, materials);
  factor();
}

void Solver::factor() {
  nodes_.clear();
  if (operators_->nodes.functions == 0) return;
  std::vector<std::size_t> distinct;
  for (std::size_t c = 0; c < 3; ++c) {
    node_of_[c] = distinct.size();
    for (std::size_t k = 0; k < distinct.size(); ++k) {
      if (reflectances_.rho[distinct[k]] == reflectances_.rho[c]) node_of_[c] = k;
    }
    if (node_of_[c] == distinct.size()) distinct.push_back(c);
  }
  std::vector<std::unique_ptr<transfer::NodeSolver>> made(distinct.size());
  parallelFor(distinct.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      made[k] = std::make_unique<transfer::NodeSolver>(operators_->nodes, operators_->area, reflectances_.rho[distinct[k]]);
    }
  });
  for (auto& solver : made) nodes_.push_back(std::move(*solver));
}

void Solver::direct(const light::Emitter& emitter, std::span<const light::MaskBlocker> bodies, Column& column,
                    light::DirectCounts* counts, StageTimes* times) const {
  Lap lap;
  const light::Receivers& receivers = operators_->texels.receivers;
  column.direct.resize(receivers.slotCount());
  column.lit.resize(receivers.clusters.size());
  light::directIlluminance(light::PreparedLight(emitter), receivers, scene_->blockers,
                           {.epsilon = scene_->epsilon, .bodies = bodies}, column.direct, column.lit, counts);
  if (times != nullptr) times->direct += lap.ms();
}

void Solver::gatherAll(const std::vector<vec4>& x, std::vector<vec4>& y) const {
  y.resize(operators_->lists.lists.size());
  parallelFor(y.size(), 64, [&](std::size_t begin, std::size_t end) {
    transfer::gather(operators_->lists, begin, x, std::span(y).subspan(begin, end - begin));
  });
  // The light that leaves the texels arrives somewhere: what the skeleton's rays and weights get
  // wrong about the sum is put right by one factor per channel.
  dvec3 sent(0.0);
  for (std::size_t s = 0; s < x.size(); ++s) {
    const double a = static_cast<double>(operators_->area[s]) * static_cast<double>(operators_->kept[s]);
    sent += a * dvec3(x[s].x, x[s].y, x[s].z);
  }
  dvec3 arrived(0.0);
  for (std::size_t k = 0; k < y.size(); ++k) {
    arrived += static_cast<double>(operators_->list_area[k]) * dvec3(y[k].x, y[k].y, y[k].z);
  }
  vec4 scale(1.0F);
  for (int c = 0; c < 3; ++c) {
    if (arrived[c] > 0.0) scale[c] = static_cast<float>(std::clamp(sent[c] / arrived[c], 0.9, 1.1));
  }
  for (vec4& v : y) v *= scale;
}

void Solver::indirect(Column& column, std::span<const float> open, const SolveOptions& options,
                      std::vector<vec4>* source, StageTimes* times) const {
  const transfer::Operators& op = *operators_;
  const std::size_t slots = op.texels.slotCount();
  if (op.nodes.functions == 0) return;
  Lap lap;
  const auto directAt = [&](std::size_t s) {
    const float e = column.direct[op.fill_from[s]];
    return open.empty() ? e : e * open[s];
  };
  std::array<std::vector<float>, 3> x0;
  std::array<std::vector<float>, 3> b0;
  const std::size_t channels = nodes_.size();
  std::array<std::size_t, 3> channel_of{};  // a color channel for each distinct solver
  for (std::size_t c = 3; c-- > 0;) channel_of[node_of_[c]] = c;
  parallelFor(channels, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::vector<float>& rho = reflectances_.rho[channel_of[k]];
      x0[k].resize(slots);
      b0[k].assign(op.nodes.stride, 0.0F);
      for (std::size_t s = 0; s < slots; ++s) x0[k][s] = rho[s] * directAt(s);
      transfer::restrictToNodes(op.nodes, op.area, x0[k], b0[k]);
    }
  });
  if (times != nullptr) times->restrict_ += lap.ms();
  for (std::size_t k = 0; k < channels; ++k) {
    column.node[k].assign(op.nodes.stride, 0.0F);
    nodes_[k].solve(b0[k], column.node[k]);
  }
  for (std::size_t c = 3; c-- > 0;) {
    if (node_of_[c] != c) column.node[c] = column.node[node_of_[c]];
  }
  if (times != nullptr) times->nodes += lap.ms();
  column.skeleton.clear();
  if (op.coarse && source == nullptr) return;
  std::vector<vec4> x(slots, vec4(0.0F));
  parallelFor(op.nodes.patches.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const transfer::Nodes::Patch& p = op.nodes.patches[i];
      for (std::uint32_t s = p.begin; s < p.end; ++s) {
        const float e = directAt(s);
        const float shown = open.empty() ? 1.0F : open[s];
        for (int c = 0; c < 3; ++c) {
          const auto k = static_cast<std::size_t>(c);
          const std::vector<float>& coefficients = column.node[k];
          float value = coefficients[p.first];
          if (p.count > 1) value += coefficients[p.first + 1] * op.nodes.phi[s].x;
          if (p.count > 2) value += coefficients[p.first + 2] * op.nodes.phi[s].y;
          x[s][c] = reflectances_.rho[k][s] * (e + shown * std::max(0.0F, value));
        }
      }
    }
  });
  if (times != nullptr) times->source += lap.ms();
  if (!op.coarse) {
    gatherAll(x, column.skeleton);
    for (int sweep = 0; sweep < options.sweeps; ++sweep) {
      std::array<std::vector<float>, 3> field;
      for (auto& plane : field) plane.assign(slots, 0.0F);
      const std::vector<float> none;
      Column only;
      only.skeleton = column.skeleton;
      add(only, dvec3(1.0), field);
      for (std::size_t s = 0; s < slots; ++s) {
        const std::uint32_t from = op.fill_from[s];
        const float shown = open.empty() ? 1.0F : open[s];
        for (int c = 0; c < 3; ++c) {
          const auto k = static_cast<std::size_t>(c);
          x[s][c] = reflectances_.rho[k][s] * (directAt(s) + shown * std::max(0.0F, field[k][from]));
        }
      }
      gatherAll(x, column.skeleton);
    }
  }
  if (times != nullptr) times->gather += lap.ms();
  if (source != nullptr) *source = std::move(x);
}

void Solver::add(const Column& column, const dvec3& weight, std::array<std::vector<float>, 3>& total,
                 StageTimes* times) const {
  Lap lap;
  const transfer::Operators& op = *operators_;
  const vec4 w(vec3(weight), 0.0F);
  parallelFor(op.texels.receivers.clusters.size(), 8, [&](std::size_t begin, std::size_t end) {
    std::vector<vec4> y;
    for (std::size_t i = begin; i < end; ++i) {
      const light::Receivers::Cluster& c = op.texels.receivers.clusters[i];
      float* r = &total[0][c.begin];
      float* g = &total[1][c.begin];
      float* b = &total[2][c.begin];
      const std::size_t slots = c.end - c.begin;
      if (!column.direct.empty() && column.lit[i] != 0) {
        transfer::addScaled(w.x, &column.direct[c.begin], r, slots);
        transfer::addScaled(w.y, &column.direct[c.begin], g, slots);
        transfer::addScaled(w.z, &column.direct[c.begin], b, slots);
      }
      if (!column.skeleton.empty()) {
        const transfer::ClusterWeights& cw = op.clusters[i];
        y.assign(column.skeleton.begin() + cw.first_list, column.skeleton.begin() + cw.first_list + cw.rank);
        for (vec4& v : y) v *= w;
        transfer::interpolate(std::span(op.weights).subspan(cw.first_weight, cw.rank * slots), y, slots, r, g, b);
      } else if (!column.node[0].empty()) {
        for (std::uint32_t s = c.begin; s < c.end; ++s) {
          const transfer::Nodes::Patch& p = op.nodes.patches[op.nodes.patch_of[s]];
          for (std::size_t k = 0; k < 3; ++k) {
            const std::vector<float>& coefficients = column.node[k];
            float value = coefficients[p.first];
            if (p.count > 1) value += coefficients[p.first + 1] * op.nodes.phi[s].x;
            if (p.count > 2) value += coefficients[p.first + 2] * op.nodes.phi[s].y;
            total[k][s] += w[static_cast<int>(k)] * std::max(0.0F, value);
          }
        }
      }
    }
  });
  if (times != nullptr) times->interpolate += lap.ms();
}

void Solver::fill(std::array<std::vector<float>, 3>& total) const {
  for (auto& plane : total) {
    for (const std::uint32_t s : filled_) plane[s] = plane[operators_->fill_from[s]];
  }
}

}  // namespace soffit::relight

// SPDX-License-Identifier: MIT
#include "core/relight/solver.h"

#include "core/base/parallel.h"

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
  shadow_groups_ = transfer::makeShadowGroups(operators_->texels, operators_->fill_from);
  for (std::uint32_t s = 0; s < operators_->fill_from.size(); ++s) {
    if (operators_->fill_from[s] != s) filled_.push_back(s);
  }
  const transfer::Nodes& nodes = operators_->nodes;
  kept_moment_.assign(nodes.stride, 0.0F);
  for (const transfer::Nodes::Patch& p : nodes.patches) {
    for (std::uint32_t s = p.begin; s < p.end; ++s) {
      const float a = operators_->area[s] * operators_->kept[s];
      kept_moment_[p.first] += a;
      if (p.count > 1) kept_moment_[p.first + 1] += a * nodes.phi[s].x;
      if (p.count > 2) kept_moment_[p.first + 2] += a * nodes.phi[s].y;
    }
  }
}

void Solver::setMaterials(std::span<const scene::Material> materials) {
  reflectances_ = makeReflectances(operators_->texels, materials);
  makePalettes();
  factor();
}

void Solver::factor() {
  nodes_.reset();
  channels_ = 0;
  if (operators_->nodes.functions == 0) return;
  std::vector<std::span<const float>> distinct;
  for (std::size_t c = 0; c < 3; ++c) {
    node_of_[c] = distinct.size();
    for (std::size_t k = 0; k < distinct.size(); ++k) {
      if (std::ranges::equal(distinct[k], reflectances_.rho[c])) node_of_[c] = k;
    }
    if (node_of_[c] == distinct.size()) distinct.emplace_back(reflectances_.rho[c]);
  }
  channels_ = distinct.size();
  nodes_.emplace(operators_->nodes, operators_->area, distinct);
}

void Solver::makePalettes() {
  const auto& clusters = operators_->texels.receivers.clusters;
  const auto& rho = reflectances_.rho;
  palettes_.assign(clusters.size(), {});
  place_.assign(operators_->texels.slotCount(), 0);
  parallelFor(clusters.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      transfer::Palette& palette = palettes_[i];
      for (std::uint32_t s = clusters[i].begin; s < clusters[i].end; ++s) {
        std::uint32_t k = 0;
        while (k < palette.size && (palette.rho[0][k] != rho[0][s] || palette.rho[1][k] != rho[1][s] ||
                                    palette.rho[2][k] != rho[2][s])) {
          ++k;
        }
        if (k == transfer::Palette::kMost) {
          palette.size = 0;
          break;
        }
        if (k == palette.size) {
          for (std::size_t c = 0; c < 3; ++c) palette.rho[c][k] = rho[c][s];
          ++palette.size;
        }
        place_[s] = static_cast<std::uint8_t>(k);
      }
    }
  });
}

void Solver::direct(const light::Emitter& emitter, std::span<const light::MaskBlocker> bodies, Column& column,
                    light::DirectCounts* counts, StageTimes* times) const {
  Lap lap;
  const light::Receivers& receivers = operators_->texels.receivers;
  column.direct.resize(receivers.slotCount());
  column.lit.resize(receivers.clusters.size());
  std::vector<float> lux(shadow_groups_.points.slotCount());
  std::vector<std::uint8_t> lit(shadow_groups_.points.clusters.size());
  light::directIlluminance(light::PreparedLight(emitter), shadow_groups_.points, scene_->blockers,
                           {.epsilon = scene_->epsilon, .bodies = bodies}, lux, lit, counts);
  parallelFor(receivers.clusters.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      float most = 0.0F;
      for (std::uint32_t s = receivers.clusters[i].begin; s < receivers.clusters[i].end; ++s) {
        column.direct[s] = lux[shadow_groups_.place[s]];
        most = std::max(most, column.direct[s]);
      }
      column.lit[i] = most > 0.0F ? 1 : 0;
    }
  });
  if (times != nullptr) times->direct += lap.ms();
}

void Solver::conserve(const dvec3& sent, std::vector<vec4>& y) const {
  // The light that leaves the texels arrives somewhere: what the skeleton's rays and weights get
  // wrong about the sum is put right by one factor per channel.
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

void Solver::firstBounce(const Column& column, std::span<const float> open, std::vector<vec4>& y1, Planes& e1) const {
  const transfer::Operators& op = *operators_;
  const auto& clusters = op.texels.receivers.clusters;
  std::vector<float> lux(op.texels.slotCount());
  std::vector<dvec3> sent_by(clusters.size(), dvec3(0.0));
  parallelFor(clusters.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (column.lit[i] == 0) continue;  // these taps are skipped
      for (std::uint32_t s = clusters[i].begin; s < clusters[i].end; ++s) {
        const float e = directAt(column, open, s);
        lux[s] = transfer::TintedLight::pack(e, place_[s]);
        const float a = op.area[s] * op.kept[s] * e;
        sent_by[i] += dvec3(a * reflectances_.rho[0][s], a * reflectances_.rho[1][s], a * reflectances_.rho[2][s]);
      }
    }
  });
  const transfer::TintedLight light{
      lux, {reflectances_.rho[0], reflectances_.rho[1], reflectances_.rho[2]}, palettes_, column.lit};
  y1.resize(op.lists.lists.size());
  parallelFor(y1.size(), 64, [&](std::size_t begin, std::size_t end) {
    transfer::gatherTinted(op.lists, begin, light, std::span(y1).subspan(begin, end - begin));
  });
  dvec3 sent(0.0);
  for (const dvec3& s : sent_by) sent += s;
  conserve(sent, y1);
  parallelFor(clusters.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const light::Receivers::Cluster& c = clusters[i];
      const std::size_t slots = c.end - c.begin;
      const transfer::ClusterWeights& cw = op.clusters[i];
      for (auto& plane : e1) std::fill(plane.begin() + c.begin, plane.begin() + c.end, 0.0F);
      transfer::interpolate(std::span(op.weights).subspan(cw.first_weight, cw.rank * slots),
                            std::span(y1).subspan(cw.first_list, cw.rank), slots, &e1[0][c.begin], &e1[1][c.begin],
                            &e1[2][c.begin]);
    }
  });
}

void Solver::solveNodes(const Planes& radiosity, Planes& coefficients, Planes& sent) const {
  const transfer::Operators& op = *operators_;
  transfer::NodeSolver::Vectors b(channels_, std::vector<float>(op.nodes.stride, 0.0F));
  transfer::NodeSolver::Vectors e;
  parallelFor(channels_, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      transfer::restrictToNodes(op.nodes, op.area, radiosity[colourOf(k)], b[k]);
    }
  });
  nodes_->solve(b, e);
  std::vector<float> more(op.nodes.stride, 0.0F);
  for (std::size_t k = 0; k < channels_; ++k) {
    nodes_->reflect(k, e[k], more);
    for (std::size_t f = 0; f < more.size(); ++f) b[k][f] += more[f];
  }
  for (std::size_t c = 0; c < 3; ++c) {
    coefficients[c] = e[node_of_[c]];
    sent[c] = b[node_of_[c]];
  }
}

void Solver::gatherFromNodes(const Planes& sent, std::vector<vec4>& y) const {
  const transfer::Operators& op = *operators_;
  // Two functions of padding: the kernel reads three per patch.
  std::vector<vec4> b(op.nodes.stride + 2, vec4(0.0F));
  dvec3 total(0.0);
  for (std::size_t f = 0; f < op.nodes.functions; ++f) {
    b[f] = vec4(sent[0][f], sent[1][f], sent[2][f], 0.0F);
    total += static_cast<double>(kept_moment_[f]) * dvec3(b[f].x, b[f].y, b[f].z);
  }
  y.assign(op.lists.lists.size(), vec4(0.0F));
  parallelFor(y.size(), 64, [&](std::size_t begin, std::size_t end) {
    transfer::gatherNodes(op.node_lists, begin, b, std::span(y).subspan(begin, end - begin));
  });
  conserve(total, y);
}

void Solver::radiosityOf(const Column& column, std::span<const float> open, const Planes* e1,
                         const Planes& coefficients, std::vector<vec4>& source) const {
  const transfer::Operators& op = *operators_;
  source.assign(op.texels.slotCount(), vec4(0.0F));
  parallelFor(op.nodes.patches.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const transfer::Nodes::Patch& p = op.nodes.patches[i];
      for (std::uint32_t s = p.begin; s < p.end; ++s) {
        const std::uint32_t from = op.fill_from[s];
        const float shown = open.empty() ? 1.0F : open[s];
        for (std::size_t c = 0; c < 3; ++c) {
          const std::vector<float>& k = coefficients[c];
          float e = k[p.first];
          if (p.count > 1) e += k[p.first + 1] * op.nodes.phi[s].x;
          if (p.count > 2) e += k[p.first + 2] * op.nodes.phi[s].y;
          e = std::max(0.0F, e) + (e1 != nullptr ? std::max(0.0F, (*e1)[c][from]) : 0.0F);
          source[s][static_cast<int>(c)] = reflectances_.rho[c][s] * (directAt(column, open, s) + shown * e);
        }
      }
    }
  });
}

void Solver::coarseIndirect(Column& column, std::span<const float> open, std::vector<vec4>* source) const {
  const std::size_t slots = operators_->texels.slotCount();
  Planes x;
  for (std::size_t c = 0; c < 3; ++c) {
    x[c].resize(slots);
    for (std::size_t s = 0; s < slots; ++s) x[c][s] = reflectances_.rho[c][s] * directAt(column, open, s);
  }
  Planes sent;
  column.skeleton.clear();
  solveNodes(x, column.node, sent);
  if (source != nullptr) radiosityOf(column, open, nullptr, column.node, *source);
}

void Solver::indirect(Column& column, std::span<const float> open, std::vector<vec4>* source,
                      StageTimes* times) const {
  const transfer::Operators& op = *operators_;
  if (op.nodes.functions == 0) return;
  if (op.coarse) {
    coarseIndirect(column, open, source);
    return;
  }
  Lap lap;
  const std::size_t slots = op.texels.slotCount();
  Planes e1;
  for (auto& plane : e1) plane.resize(slots);
  firstBounce(column, open, column.skeleton, e1);
  if (times != nullptr) times->first_bounce += lap.ms();
  Planes b1;
  parallelFor(3, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      if (colourOf(node_of_[c]) != c) continue;  // an equal channel is not computed twice
      b1[c].resize(slots);
      for (std::size_t s = 0; s < slots; ++s) {
        const float shown = open.empty() ? 1.0F : open[s];
        b1[c][s] = reflectances_.rho[c][s] * shown * std::max(0.0F, e1[c][op.fill_from[s]]);
      }
    }
  });
  Planes coefficients;
  Planes sent;
  solveNodes(b1, coefficients, sent);
  if (times != nullptr) times->nodes += lap.ms();
  std::vector<vec4> y2;
  gatherFromNodes(sent, y2);
  for (std::size_t k = 0; k < y2.size(); ++k) column.skeleton[k] += y2[k];
  if (times != nullptr) times->gather += lap.ms();
  if (source != nullptr) radiosityOf(column, open, &e1, coefficients, *source);
}

void Solver::addCluster(const Column& column, const vec4& w, std::size_t i, Planes& total) const {
  const transfer::Operators& op = *operators_;
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
    std::array<vec4, 256> y;
    for (std::uint32_t k = 0; k < cw.rank; ++k) y[k] = w * column.skeleton[cw.first_list + k];
    // Weights may be negative; light is not.
    alignas(64) std::array<std::array<float, 256>, 3> light{};
    transfer::interpolate(std::span(op.weights).subspan(cw.first_weight, cw.rank * slots),
                          std::span<const vec4>(y.data(), cw.rank), slots, light[0].data(), light[1].data(),
                          light[2].data());
    for (std::size_t s = 0; s < slots; ++s) {
      r[s] += std::max(0.0F, light[0][s]);
      g[s] += std::max(0.0F, light[1][s]);
      b[s] += std::max(0.0F, light[2][s]);
    }
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

void Solver::add(const Column& column, const dvec3& weight, Planes& total, StageTimes* times) const {
  Lap lap;
  const vec4 w(vec3(weight), 0.0F);
  parallelFor(operators_->texels.receivers.clusters.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) addCluster(column, w, i, total);
  });
  if (times != nullptr) times->interpolate += lap.ms();
}

void Solver::addTo(const Column& column, const dvec3& weight, const Planes& rest, Planes& total,
                   StageTimes* times) const {
  Lap lap;
  const vec4 w(vec3(weight), 0.0F);
  const auto& clusters = operators_->texels.receivers.clusters;
  for (std::size_t k = 0; k < 3; ++k) total[k].resize(rest[k].size());
  parallelFor(clusters.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        std::copy(rest[k].begin() + clusters[i].begin, rest[k].begin() + clusters[i].end,
                  total[k].begin() + clusters[i].begin);
      }
      addCluster(column, w, i, total);
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

// SPDX-License-Identifier: MIT
#include "core/relight/solver.h"

#include "core/base/parallel.h"
#include "core/relight/direct_light.h"
#include "core/relight/light_sum.h"

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

Solver::Solver(std::shared_ptr<const transfer::StaticScene> scene,
               std::shared_ptr<const transfer::Operators> operators,
               std::span<const scene::Material> materials)
    : scene_(std::move(scene)), operators_(std::move(operators)) {
  setMaterials(materials);
  blocks_ = transfer::FarBlocks(operators_->texels, operators_->area);
  shadow_groups_ = transfer::makeShadowGroups(operators_->texels, operators_->fill_from);
  const transfer::Nodes& nodes = operators_->nodes;
  const auto& clusters = operators_->texels.receivers.clusters;
  for (std::uint32_t i = 0; i < nodes.patches.size(); ++i) {
    const transfer::Nodes::Patch& p = nodes.patches[i];
    // The last cluster may have further patches.
    const std::size_t next = first_patch_.size();
    if (next < clusters.size() && p.begin == clusters[next].begin) first_patch_.push_back(i);
    vec3& moment = sends_moment_.emplace_back(0.0F);
    for (std::uint32_t s = p.begin; s < p.end; ++s) {
      moment += operators_->sends[s] * vec3(1.0F, nodes.phi[s].x, nodes.phi[s].y);
    }
  }
  first_patch_.push_back(static_cast<std::uint32_t>(nodes.patches.size()));
}

void Solver::setMaterials(std::span<const scene::Material> materials) {
  reflectances_ = makeReflectances(operators_->texels, materials);
  auto& rho = reflectances_.rho;
  for (std::size_t s = 0; s < operators_->texels.slotCount(); ++s) {
    if (operators_->buried[s] == 0) continue;
    for (auto& channel : rho) channel[s] = 0.0F;
  }
  const std::array<std::span<const float>, 3> channels = {rho[0], rho[1], rho[2]};
  nodes_.reset();
  if (operators_->nodes.functions > 0)
    nodes_.emplace(operators_->nodes, operators_->area, channels);
  if (!operators_->coarse) patch_weights_ = transfer::makePatchWeights(*operators_, channels);
}

void Solver::direct(const light::Emitter& emitter, std::span<const light::MaskBlocker> bodies,
                    Column& column, light::DirectCounts* counts, StageTimes* times) const {
  Lap lap;
  if (local_) {
    const light::Receivers& receivers = operators_->texels.receivers;
    column.direct.resize(receivers.slotCount());
    column.lit.resize(receivers.clusters.size());
    local_->illuminate(emitter, column.direct, column.lit);
    if (times != nullptr) times->direct += lap.ms();
    return;
  }
  std::vector<float> lux(shadow_groups_.points.slotCount());
  std::vector<std::uint8_t> lit(shadow_groups_.points.clusters.size());
  directLight(*scene_, light::PreparedLight(emitter), shadow_groups_.points, bodies, lux, lit,
              counts);
  readDirect(lux, column);
  if (times != nullptr) times->direct += lap.ms();
}

void Solver::directAgain(const light::Emitter& emitter, std::span<const light::MaskBlocker> bodies,
                         std::span<const Box> changed, Column& column, light::DirectCounts* counts,
                         StageTimes* times) const {
  if (local_) return;  // bodies do not shade
  Lap lap;
  const light::Receivers& points = shadow_groups_.points;
  std::vector<float> lux(points.slotCount());
  std::vector<std::uint8_t> lit(points.clusters.size());
  for (std::size_t s = 0; s < column.direct.size(); ++s) {
    lux[shadow_groups_.place[s]] = column.direct[s];
  }
  // The last group is filled up with its last point.
  for (const light::Receivers::Cluster& c : points.clusters) {
    std::fill(lux.begin() + c.begin + c.used, lux.begin() + c.end, lux[c.begin + c.used - 1]);
  }
  directLight(*scene_, light::PreparedLight(emitter), points, bodies, lux, lit, counts, changed);
  readDirect(lux, column);
  if (times != nullptr) times->direct += lap.ms();
}

/// From the direct stage's order to the texels'.
void Solver::readDirect(std::span<const float> lux, Column& column) const {
  const light::Receivers& receivers = operators_->texels.receivers;
  column.direct.resize(receivers.slotCount());
  column.lit.resize(receivers.clusters.size());
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
}

vec4 Solver::conservingScale(const dvec3& sent, std::span<const vec4> y) const {
  // The light that leaves the texels arrives somewhere: what the skeleton's rays and weights get
  // wrong about the sum is put right by one factor per channel.
  dvec3 arrived(0.0);
  for (std::size_t k = 0; k < y.size(); ++k) {
    arrived += static_cast<double>(operators_->list_area[k]) * dvec3(y[k].x, y[k].y, y[k].z);
  }
  vec4 scale(1.0F);
  for (int c = 0; c < 3; ++c) {
    if (arrived[c] <= 0.0) continue;
    const double wanted = std::clamp(sent[c] / arrived[c], 0.9, 1.1);
    scale[c] = static_cast<float>(1.0 + static_cast<double>(operators_->conserve) * (wanted - 1.0));
  }
  return scale;
}

dvec3 Solver::sendDirect(const Column& column, std::span<const float> open,
                         std::span<vec4> x) const {
  const transfer::Operators& op = *operators_;
  const auto& clusters = op.texels.receivers.clusters;
  const auto& rho = reflectances_.rho;
  std::vector<dvec3> sent_by(clusters.size(), dvec3(0.0));
  parallelFor(clusters.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (column.lit[i] == 0) continue;
      vec3 sum(0.0F);
      for (std::uint32_t s = clusters[i].begin; s < clusters[i].end; ++s) {
        const vec3 b = directAt(column, open, s) * vec3(rho[0][s], rho[1][s], rho[2][s]);
        x[s] = vec4(b, 0.0F);
        sum += op.sends[s] * b;
      }
      blocks_.average(clusters[i].begin, clusters[i].end, x);
      sent_by[i] = dvec3(sum);
    }
  });
  dvec3 sent(0.0);
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    if (column.lit[i] != 0) sent += sent_by[i];
  }
  return sent;
}

void Solver::firstBounce(Column& column, std::span<const float> open,
                         std::span<transfer::PatchLight> sent) const {
  const transfer::Operators& op = *operators_;
  const auto& clusters = op.texels.receivers.clusters;
  std::vector<vec4> x(blocks_.size(), vec4(0.0F));
  const dvec3 all = sendDirect(column, open, x);
  std::vector<vec4>& y = column.skeleton;
  y.resize(op.lists.lists.size());
  parallelFor(y.size(), 64, [&](std::size_t begin, std::size_t end) {
    transfer::gather(op.lists, begin, x, std::span(y).subspan(begin, end - begin));
  });
  const vec4 scale = conservingScale(all, y);
  parallelFor(clusters.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::span<vec4> own =
          std::span(y).subspan(op.clusters[i].first_list, op.clusters[i].rank);
      for (vec4& v : own) v *= scale;
      if (!open.empty()) {
        sendCovered(own, open, i, sent);
        continue;
      }
      for (std::uint32_t p = first_patch_[i]; p < first_patch_[i + 1]; ++p) {
        sent[p] = transfer::sentOn(patch_weights_, p, own);
      }
    }
  });
}

void Solver::sendCovered(std::span<const vec4> y, std::span<const float> open, std::size_t i,
                         std::span<transfer::PatchLight> sent) const {
  const transfer::Operators& op = *operators_;
  const light::Receivers::Cluster& c = op.texels.receivers.clusters[i];
  const std::size_t slots = c.end - c.begin;
  alignas(64) std::array<std::array<float, 256>, 3> e;
  for (auto& plane : e) std::fill_n(plane.begin(), slots, 0.0F);
  transfer::interpolate(
      std::span(op.weights).subspan(op.clusters[i].first_weight, y.size() * slots), y, slots,
      e[0].data(), e[1].data(), e[2].data());
  for (auto& plane : e) {
    for (std::size_t s = 0; s < slots; ++s) plane[s] *= open[c.begin + s];
  }
  const auto& rho = reflectances_.rho;
  for (std::uint32_t p = first_patch_[i]; p < first_patch_[i + 1]; ++p) {
    const transfer::Nodes::Patch& patch = op.nodes.patches[p];
    const std::size_t from = patch.begin - c.begin;
    sent[p] = transfer::restrictSent(op.nodes, patch, op.area, {rho[0], rho[1], rho[2]},
                                     {&e[0][from], &e[1][from], &e[2][from]});
  }
}

void Solver::addFromNodes(std::span<const transfer::PatchLight> sent, std::vector<vec4>& y) const {
  const transfer::Operators& op = *operators_;
  dvec3 total(0.0);
  std::vector<vec4> constants(sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    constants[i] = sent[i].c[0];
    for (int a = 0; a < 3; ++a) {
      const vec4& b = sent[i].c[static_cast<std::size_t>(a)];
      total += static_cast<double>(sends_moment_[i][a]) * dvec3(b.x, b.y, b.z);
    }
  }
  std::vector<vec4> more(y.size());
  parallelFor(more.size(), 256, [&](std::size_t begin, std::size_t end) {
    transfer::gatherNodes(op.node_lists, begin, sent, constants,
                          std::span(more).subspan(begin, end - begin));
  });
  const vec4 scale = conservingScale(total, more);
  for (std::size_t k = 0; k < y.size(); ++k) y[k] += scale * more[k];
}

void Solver::sweep(Column& column, std::span<const float> open) const {
  const transfer::Operators& op = *operators_;
  const auto& clusters = op.texels.receivers.clusters;
  const auto& rho = reflectances_.rho;
  std::vector<vec4>& y = column.skeleton;
  std::vector<vec4> e(op.texels.slotCount());
  parallelFor(clusters.size(), 8, [&](std::size_t begin, std::size_t end) {
    alignas(64) std::array<std::array<float, 256>, 3> light;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t at = clusters[i].begin;
      const std::size_t slots = clusters[i].end - at;
      for (auto& plane : light) std::fill_n(plane.begin(), slots, 0.0F);
      const transfer::ClusterWeights& w = op.clusters[i];
      transfer::interpolate(std::span(op.weights).subspan(w.first_weight, w.rank * slots),
                            std::span(y).subspan(w.first_list, w.rank), slots, light[0].data(),
                            light[1].data(), light[2].data());
      for (std::size_t s = 0; s < slots; ++s) {
        e[at + s] = vec4(light[0][s], light[1][s], light[2][s], 0.0F);
      }
    }
  });
  std::vector<vec4> x(blocks_.size(), vec4(0.0F));
  std::vector<dvec3> sent_by(clusters.size(), dvec3(0.0));
  parallelFor(clusters.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      vec3 sum(0.0F);
      for (std::uint32_t s = clusters[i].begin; s < clusters[i].end; ++s) {
        const float shown = open.empty() ? 1.0F : open[s];
        const vec3 b = vec3(rho[0][s], rho[1][s], rho[2][s]) *
                       (directAt(column, open, s) + shown * vec3(e[op.fill_from[s]]));
        x[s] = vec4(b, 0.0F);
        sum += op.sends[s] * b;
      }
      blocks_.average(clusters[i].begin, clusters[i].end, x);
      sent_by[i] = dvec3(sum);
    }
  });
  dvec3 sent(0.0);
  for (const dvec3& s : sent_by) sent += s;
  parallelFor(y.size(), 64, [&](std::size_t begin, std::size_t end) {
    transfer::gather(op.lists, begin, x, std::span(y).subspan(begin, end - begin));
  });
  const vec4 scale = conservingScale(sent, y);
  for (vec4& v : y) v *= scale;
}

void Solver::radiosityOf(const Column& column, std::span<const float> open,
                         std::vector<vec4>& source) const {
  const transfer::Operators& op = *operators_;
  Planes e;
  const WeightedColumn one{&column, dvec3(1.0)};
  spread({}, {&one, 1}, op, e, LightPart::reflected);
  source.assign(op.texels.slotCount(), vec4(0.0F));
  parallelFor(source.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      const float shown = open.empty() ? 1.0F : open[s];
      const float direct = directAt(column, open, s);
      for (std::size_t c = 0; c < 3; ++c) {
        source[s][static_cast<int>(c)] = reflectances_.rho[c][s] * (direct + shown * e[c][s]);
      }
    }
  });
}

void Solver::coarseIndirect(Column& column, std::span<const float> open,
                            std::vector<vec4>* source) const {
  const transfer::Operators& op = *operators_;
  const auto& rho = reflectances_.rho;
  std::vector<float> e(op.texels.slotCount());
  for (std::size_t s = 0; s < e.size(); ++s) e[s] = directAt(column, open, s);
  std::vector<transfer::PatchLight> sent(op.nodes.patches.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const transfer::Nodes::Patch& patch = op.nodes.patches[i];
    const float* from = &e[patch.begin];
    sent[i] = transfer::restrictSent(op.nodes, patch, op.area, {rho[0], rho[1], rho[2]},
                                     {from, from, from});
  }
  column.skeleton.clear();
  column.node.resize(sent.size());
  nodes_->solve(sent, column.node);
  if (source != nullptr) radiosityOf(column, open, *source);
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
  std::vector<transfer::PatchLight> sent(op.nodes.patches.size());
  firstBounce(column, open, sent);
  if (times != nullptr) times->first_bounce += lap.ms();
  std::vector<transfer::PatchLight> more(sent.size());
  std::vector<transfer::PatchLight> sent_on(sent.size());
  nodes_->solve(sent, more);
  nodes_->reflect(more, sent_on);
  for (std::size_t i = 0; i < sent.size(); ++i) {
    for (std::size_t a = 0; a < 3; ++a) sent[i].c[a] += sent_on[i].c[a];
  }
  if (times != nullptr) times->nodes += lap.ms();
  addFromNodes(sent, column.skeleton);
  if (times != nullptr) times->gather += lap.ms();
  for (int k = 0; k < sweeps_; ++k) sweep(column, open);
  if (times != nullptr) times->sweep += lap.ms();
  if (source != nullptr) radiosityOf(column, open, *source);
}

}  // namespace soffit::relight

// SPDX-License-Identifier: MIT
#include "core/relight/light_sum.h"

#include "core/base/parallel.h"
#include "core/transfer/kernels.h"

#include <algorithm>
#include <array>

namespace soffit::relight {
namespace {

constexpr std::uint32_t kMostSlots = 256;  ///< of a cluster

/// Reflected light of all parts together, before it is interpolated.
struct Reflected {
  std::vector<vec4> skeleton;
  std::vector<transfer::PatchLight> node;
};

void addScaled(std::span<const vec4> from, const vec4& weight, std::vector<vec4>& to) {
  if (from.empty()) return;
  to.resize(from.size(), vec4(0.0F));
  for (std::size_t k = 0; k < from.size(); ++k) to[k] += weight * from[k];
}

void addScaled(std::span<const transfer::PatchLight> from, const vec4& weight,
               std::vector<transfer::PatchLight>& to) {
  if (from.empty()) return;
  to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t a = 0; a < 3; ++a) to[i].c[a] += weight * from[i].c[a];
  }
}

vec4 channels(const dvec3& weight) {
  return {vec3(weight), 0.0F};
}

/// One of them, or of a LightSum's.
struct Part {
  std::span<const vec4> skeleton;
  std::span<const transfer::PatchLight> node;
  vec4 weight;
};

Reflected together(std::span<const WeightedSum> sums, std::span<const WeightedColumn> columns) {
  std::vector<Part> parts;
  for (const WeightedSum& s : sums) {
    parts.push_back({s.sum->skeleton, s.sum->node, channels(s.factor)});
  }
  for (const WeightedColumn& c : columns) {
    parts.push_back({c.column->skeleton, c.column->node, channels(c.weight)});
  }
  Reflected all;
  std::size_t lists = 0;
  for (const Part& p : parts) {
    addScaled(p.node, p.weight, all.node);
    lists = std::max(lists, p.skeleton.size());
  }
  all.skeleton.assign(lists, vec4(0.0F));
  parallelFor(lists, 1024, [&](std::size_t begin, std::size_t end) {
    for (const Part& p : parts) {
      for (std::size_t k = begin; k < std::min(end, p.skeleton.size()); ++k) {
        all.skeleton[k] += p.weight * p.skeleton[k];
      }
    }
  });
  return all;
}

/// Adds to light[c][s - begin of the cluster].
void interpolate(std::span<const vec4> skeleton, std::span<const transfer::PatchLight> node,
                 const transfer::Operators& op, std::size_t i, const std::array<float*, 3>& light) {
  const light::Receivers::Cluster& c = op.texels.receivers.clusters[i];
  if (!skeleton.empty()) {
    const transfer::ClusterWeights& cw = op.clusters[i];
    const std::size_t slots = c.end - c.begin;
    transfer::interpolate(std::span(op.weights).subspan(cw.first_weight, cw.rank * slots),
                          skeleton.subspan(cw.first_list, cw.rank), slots, light[0], light[1],
                          light[2]);
    return;
  }
  if (node.empty()) return;
  for (std::uint32_t s = c.begin; s < c.end; ++s) {
    const auto& e = node[op.nodes.patch_of[s]].c;
    const vec4 value = e[0] + e[1] * op.nodes.phi[s].x + e[2] * op.nodes.phi[s].y;
    for (std::size_t k = 0; k < 3; ++k) light[k][s - c.begin] += value[static_cast<int>(k)];
  }
}

void addDirect(std::span<const WeightedSum> sums, std::span<const WeightedColumn> columns,
               const light::Receivers::Cluster& c, std::size_t i,
               const std::array<float*, 3>& light) {
  const std::size_t slots = c.end - c.begin;
  for (const WeightedSum& s : sums) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto factor = static_cast<float>(s.factor[static_cast<int>(k)]);
      if (factor != 0.0F) {
        transfer::addScaled(factor, &s.sum->direct[k][c.begin], light[k], slots);
      }
    }
  }
  for (const WeightedColumn& one : columns) {
    if (one.column->direct.empty() || one.column->lit[i] == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      transfer::addScaled(static_cast<float>(one.weight[static_cast<int>(k)]),
                          &one.column->direct[c.begin], light[k], slots);
    }
  }
}

}  // namespace

LightSum noLight(const transfer::Operators& operators) {
  LightSum sum;
  for (auto& plane : sum.direct) plane.assign(operators.texels.slotCount(), 0.0F);
  return sum;
}

void addTo(LightSum& sum, const WeightedColumn& light, const transfer::Operators& operators) {
  addScaled(light.column->skeleton, channels(light.weight), sum.skeleton);
  addScaled(light.column->node, channels(light.weight), sum.node);
  const auto& clusters = operators.texels.receivers.clusters;
  parallelFor(clusters.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t at = clusters[i].begin;
      addDirect({}, {&light, 1}, clusters[i], i,
                {&sum.direct[0][at], &sum.direct[1][at], &sum.direct[2][at]});
    }
  });
}

void spread(std::span<const WeightedSum> sums, std::span<const WeightedColumn> columns,
            const transfer::Operators& operators, Planes& lux, LightPart part) {
  const Reflected reflected = part == LightPart::direct ? Reflected{} : together(sums, columns);
  const auto& clusters = operators.texels.receivers.clusters;
  for (auto& plane : lux) plane.resize(operators.texels.slotCount());
  parallelFor(clusters.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t at = clusters[i].begin;
      const std::size_t slots = clusters[i].end - at;
      const std::array<float*, 3> light = {&lux[0][at], &lux[1][at], &lux[2][at]};
      for (float* plane : light) std::fill_n(plane, slots, 0.0F);
      interpolate(reflected.skeleton, reflected.node, operators, i, light);
      for (float* plane : light) {
        if (part == LightPart::unbounded) continue;
        for (std::size_t s = 0; s < slots; ++s) plane[s] = std::max(plane[s], 0.0F);
      }
      if (part == LightPart::all || part == LightPart::direct)
        addDirect(sums, columns, clusters[i], i, light);
    }
  });
  const auto& from = operators.fill_from;
  for (std::size_t s = 0; s < from.size(); ++s) {
    if (from[s] == s) continue;
    for (auto& plane : lux) plane[s] = plane[from[s]];
  }
}

dvec3 luxAt(const WeightedColumn& light, const transfer::Operators& operators, std::uint32_t slot) {
  const auto& clusters = operators.texels.receivers.clusters;
  slot = operators.fill_from[slot];
  const auto after =
      std::ranges::upper_bound(clusters, slot, {}, &light::Receivers::Cluster::begin);
  const auto i = static_cast<std::size_t>(after - clusters.begin()) - 1;
  std::array<std::array<float, kMostSlots>, 3> e{};
  interpolate(light.column->skeleton, light.column->node, operators, i,
              {e[0].data(), e[1].data(), e[2].data()});
  const std::uint32_t at = slot - clusters[i].begin;
  const double direct = light.column->direct.empty() ? 0.0 : light.column->direct[slot];
  dvec3 lux(0.0);
  for (int c = 0; c < 3; ++c) {
    const double indirect = e[static_cast<std::size_t>(c)][at];
    lux[c] = std::max(0.0, light.weight[c] * indirect) + light.weight[c] * direct;
  }
  return lux;
}

}  // namespace soffit::relight

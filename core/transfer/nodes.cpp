// SPDX-License-Identifier: MIT
#include "core/transfer/nodes.h"

#include "core/base/parallel.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace soffit::transfer {
namespace {

/// Linear functions of position in the patch's tangent plane, orthonormalised (Gram-Schmidt).
void makeBasis(const Texels& texels, std::span<const float> area, Nodes::Patch& patch, std::vector<vec2>& phi) {
  double total = 0.0;
  dvec3 center(0.0);
  dvec3 n(0.0);
  for (std::uint32_t s = patch.begin; s < patch.end; ++s) {
    const double a = static_cast<double>(area[s]);
    total += a;
    center += a * dvec3(texels.receivers.position(s));
    n += a * dvec3(texels.receivers.normal(s));
  }
  patch.area = total;
  patch.count = 1;
  if (total <= 0.0 || glm::length(n) <= 0.0) return;
  center /= total;
  dvec3 t;
  dvec3 b;
  orthonormalBasis(glm::normalize(n), t, b);
  double tt = 0.0;
  double tb = 0.0;
  double bb = 0.0;
  for (std::uint32_t s = patch.begin; s < patch.end; ++s) {
    const dvec3 d = dvec3(texels.receivers.position(s)) - center;
    const double a = static_cast<double>(area[s]) / total;
    tt += a * glm::dot(d, t) * glm::dot(d, t);
    tb += a * glm::dot(d, t) * glm::dot(d, b);
    bb += a * glm::dot(d, b) * glm::dot(d, b);
  }
  // Principal axes of the 2 x 2 moment matrix: the long one first.
  const double angle = 0.5 * std::atan2(2.0 * tb, tt - bb);
  const dvec3 u = std::cos(angle) * t + std::sin(angle) * b;
  const dvec3 v = std::cos(angle) * b - std::sin(angle) * t;
  const double mean = 0.5 * (tt + bb);
  const double spread = std::hypot(0.5 * (tt - bb), tb);
  const double major = mean + spread;
  const double minor = mean - spread;
  if (major <= 1e-12 * total) return;
  patch.count = minor > 1e-3 * major ? 3 : 2;
  for (std::uint32_t s = patch.begin; s < patch.end; ++s) {
    const dvec3 d = dvec3(texels.receivers.position(s)) - center;
    phi[s].x = static_cast<float>(glm::dot(d, u) / std::sqrt(major));
    phi[s].y = patch.count == 3 ? static_cast<float>(glm::dot(d, v) / std::sqrt(minor)) : 0.0F;
  }
}

}  // namespace

Nodes makeNodes(const Texels& texels, std::span<const float> area, std::uint32_t patch_size) {
  Nodes nodes;
  nodes.patch_of.assign(texels.slotCount(), 0);
  nodes.phi.assign(texels.slotCount(), vec2(0.0F));
  for (const light::Receivers::Cluster& c : texels.receivers.clusters) {
    const std::uint32_t slots = c.end - c.begin;
    const std::uint32_t parts = std::max(1U, (slots + patch_size - 1) / patch_size);
    for (std::uint32_t k = 0; k < parts; ++k) {
      Nodes::Patch patch;
      patch.begin = c.begin + slots * k / parts / 16 * 16;
      patch.end = k + 1 == parts ? c.end : c.begin + slots * (k + 1) / parts / 16 * 16;
      if (patch.begin == patch.end) continue;
      makeBasis(texels, area, patch, nodes.phi);
      patch.first = static_cast<std::uint32_t>(nodes.functions);
      nodes.functions += patch.count;
      std::fill(nodes.patch_of.begin() + patch.begin, nodes.patch_of.begin() + patch.end,
                static_cast<std::uint32_t>(nodes.patches.size()));
      nodes.patches.push_back(patch);
    }
  }
  nodes.stride = (nodes.functions + 15) / 16 * 16;
  return nodes;
}

namespace {

/// Calls f(receiver, sender, value) for every block.
template <class F>
void forEachBlock(Nodes& nodes, const F& f) {
  for (std::size_t i = 0; i < nodes.patches.size(); ++i) {
    for (std::uint32_t k = nodes.matrix.first[i]; k < nodes.matrix.first[i + 1]; ++k) {
      NodeMatrix::Block& block = nodes.matrix.blocks[k];
      f(nodes.patches[i], nodes.patches[block.sender], block.value);
    }
  }
}

/// Scales and shifts columns so that sum over receivers of A_i F_i0,b is what b's own rays say
/// arrives anywhere: A_b (1 - lost_b) for constants, the like moment for linear functions.
void conserveEnergy(Nodes& nodes, std::span<const float> area, std::span<const std::uint32_t> hits, int rays) {
  std::vector<double> sent(nodes.functions, 0.0);
  for (const Nodes::Patch& p : nodes.patches) {
    for (std::uint32_t s = p.begin; s < p.end; ++s) {
      if (area[s] <= 0.0F) continue;
      int kept = 0;
      for (int k = 0; k < rays; ++k) {
        kept += hits[static_cast<std::size_t>(s) * static_cast<std::size_t>(rays) + static_cast<std::size_t>(k)] != kNoTexel ? 1 : 0;
      }
      const double a = static_cast<double>(area[s]) * kept / rays;
      sent[p.first] += a;
      if (p.count > 1) sent[p.first + 1] += a * static_cast<double>(nodes.phi[s].x);
      if (p.count > 2) sent[p.first + 2] += a * static_cast<double>(nodes.phi[s].y);
    }
  }
  std::vector<double> arrived(nodes.functions, 0.0);
  forEachBlock(nodes, [&](const Nodes::Patch& receiver, const Nodes::Patch& sender, auto& value) {
    for (std::uint32_t b = 0; b < sender.count; ++b) {
      arrived[sender.first + b] += receiver.area * static_cast<double>(value[b]);
    }
  });
  forEachBlock(nodes, [&](const Nodes::Patch& receiver, const Nodes::Patch& sender, auto& value) {
    const double whole = arrived[sender.first];
    if (whole <= 0.0) return;
    const double scale = sent[sender.first] / whole;
    for (std::uint32_t a = 0; a < receiver.count; ++a) {
      const double before = static_cast<double>(value[3 * a]);
      for (std::uint32_t b = 1; b < sender.count && a == 0; ++b) {
        // What is missing in the linear column is spread like the constant one.
        const double missing = sent[sender.first + b] - arrived[sender.first + b];
        value[b] += static_cast<float>(before * missing / whole);
      }
      value[3 * a] = static_cast<float>(before * scale);
    }
  });
}

/// One receiving patch: sums over its texels' rays.
class RowMaker {
 public:
  RowMaker(const Nodes& nodes, std::span<const float> area, std::span<const std::uint32_t> hits,
           int rays)
      : nodes_(nodes), area_(area), hits_(hits), rays_(rays), sums_(nodes.patches.size()) {}

  std::vector<NodeMatrix::Block> make(const Nodes::Patch& p) {
    if (p.area <= 0.0) return {};
    for (std::uint32_t s = p.begin; s < p.end; ++s) {
      if (area_[s] > 0.0F) addRays(s, p);
    }
    std::sort(senders_.begin(), senders_.end());
    std::vector<NodeMatrix::Block> out;
    for (const std::uint32_t sender : senders_) {
      NodeMatrix::Block& block = out.emplace_back();
      block.sender = sender;
      for (std::size_t k = 0; k < 9; ++k) block.value[k] = static_cast<float>(sums_[sender][k]);
      sums_[sender].fill(0.0);
    }
    senders_.clear();
    return out;
  }

 private:
  void addRays(std::uint32_t slot, const Nodes::Patch& p) {
    const double weight = static_cast<double>(area_[slot]) / (p.area * rays_);
    const std::array<double, 3> w = {weight, weight * static_cast<double>(nodes_.phi[slot].x),
                                     weight * static_cast<double>(nodes_.phi[slot].y)};
    const auto rays = static_cast<std::size_t>(rays_);
    for (const std::uint32_t hit : hits_.subspan(slot * rays, rays)) {
      if (hit == kNoTexel) continue;
      const std::uint32_t sender = nodes_.patch_of[hit];
      const std::array<double, 3> phi = {1.0, static_cast<double>(nodes_.phi[hit].x),
                                         static_cast<double>(nodes_.phi[hit].y)};
      auto& sum = sums_[sender];
      if (sum[0] == 0.0) senders_.push_back(sender);
      for (std::size_t a = 0; a < p.count; ++a) {
        for (std::size_t b = 0; b < nodes_.patches[sender].count; ++b) {
          sum[3 * a + b] += w[a] * phi[b];
        }
      }
    }
  }

  const Nodes& nodes_;
  std::span<const float> area_;
  std::span<const std::uint32_t> hits_;
  int rays_;
  std::vector<std::array<double, 9>> sums_;  ///< per sender
  std::vector<std::uint32_t> senders_;       ///< whose sums are not 0
};

}  // namespace

float NodeMatrix::at(std::size_t receiver, std::size_t a, std::size_t sender, std::size_t b) const {
  for (std::uint32_t k = first[receiver]; k < first[receiver + 1]; ++k) {
    if (blocks[k].sender == sender) return blocks[k].value[3 * a + b];
  }
  return 0.0F;
}

void fillNodeMatrix(Nodes& nodes, std::span<const float> area, std::span<const std::uint32_t> hits,
                    int rays) {
  std::vector<std::vector<NodeMatrix::Block>> rows(nodes.patches.size());
  parallelFor(rows.size(), 4, [&](std::size_t begin, std::size_t end) {
    RowMaker maker(nodes, area, hits, rays);
    for (std::size_t i = begin; i < end; ++i) rows[i] = maker.make(nodes.patches[i]);
  });
  nodes.matrix = {};
  for (const auto& row : rows) {
    nodes.matrix.first.push_back(static_cast<std::uint32_t>(nodes.matrix.blocks.size()));
    nodes.matrix.blocks.insert(nodes.matrix.blocks.end(), row.begin(), row.end());
  }
  nodes.matrix.first.push_back(static_cast<std::uint32_t>(nodes.matrix.blocks.size()));
  conserveEnergy(nodes, area, hits, rays);
}

void restrictToNodes(const Nodes& nodes, std::span<const float> area, std::span<const float> value,
                     std::span<float> coefficients) {
  for (const Nodes::Patch& p : nodes.patches) {
    double c0 = 0.0;
    double c1 = 0.0;
    double c2 = 0.0;
    for (std::uint32_t s = p.begin; s < p.end; ++s) {
      const double av = static_cast<double>(area[s]) * static_cast<double>(value[s]);
      c0 += av;
      c1 += av * static_cast<double>(nodes.phi[s].x);
      c2 += av * static_cast<double>(nodes.phi[s].y);
    }
    const double inverse = p.area > 0.0 ? 1.0 / p.area : 0.0;
    coefficients[p.first] = static_cast<float>(c0 * inverse);
    if (p.count > 1) coefficients[p.first + 1] = static_cast<float>(c1 * inverse);
    if (p.count > 2) coefficients[p.first + 2] = static_cast<float>(c2 * inverse);
  }
}

void prolongFromNodes(const Nodes& nodes, std::span<const float> coefficients, std::span<float> value) {
  for (const Nodes::Patch& p : nodes.patches) {
    const float c0 = coefficients[p.first];
    const float c1 = p.count > 1 ? coefficients[p.first + 1] : 0.0F;
    const float c2 = p.count > 2 ? coefficients[p.first + 2] : 0.0F;
    for (std::uint32_t s = p.begin; s < p.end; ++s) value[s] = c0 + c1 * nodes.phi[s].x + c2 * nodes.phi[s].y;
  }
}

}  // namespace soffit::transfer

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
  for (const Nodes::Patch& p : nodes.patches) {
    const float* row = &nodes.matrix[p.first * nodes.stride];
    for (std::size_t f = 0; f < nodes.functions; ++f) arrived[f] += p.area * static_cast<double>(row[f]);
  }
  for (const Nodes::Patch& p : nodes.patches) {
    if (arrived[p.first] <= 0.0) continue;
    const double scale = sent[p.first] / arrived[p.first];
    for (const Nodes::Patch& receiver : nodes.patches) {
      for (std::uint32_t k = 0; k < receiver.count; ++k) {
        float* row = &nodes.matrix[(receiver.first + k) * nodes.stride];
        const double before = static_cast<double>(row[p.first]);
        for (std::uint32_t f = 1; f < p.count; ++f) {
          // What is missing in the linear column is spread like the constant one.
          const double missing = sent[p.first + f] - arrived[p.first + f];
          if (k == 0) row[p.first + f] += static_cast<float>(before * missing / arrived[p.first]);
        }
        row[p.first] = static_cast<float>(before * scale);
      }
    }
  }
}

}  // namespace

void fillNodeMatrix(Nodes& nodes, std::span<const float> area, std::span<const std::uint32_t> hits, int rays) {
  nodes.matrix.assign(nodes.functions * nodes.stride, 0.0F);
  parallelFor(nodes.patches.size(), 4, [&](std::size_t begin, std::size_t end) {
    std::vector<double> rows(3 * nodes.functions);
    for (std::size_t i = begin; i < end; ++i) {
      const Nodes::Patch& p = nodes.patches[i];
      if (p.area <= 0.0) continue;
      std::fill(rows.begin(), rows.end(), 0.0);
      for (std::uint32_t s = p.begin; s < p.end; ++s) {
        if (area[s] <= 0.0F) continue;
        const double weight = static_cast<double>(area[s]) / (p.area * rays);
        const std::array<double, 3> w = {weight, weight * static_cast<double>(nodes.phi[s].x),
                                         weight * static_cast<double>(nodes.phi[s].y)};
        for (int r = 0; r < rays; ++r) {
          const std::uint32_t hit = hits[static_cast<std::size_t>(s) * static_cast<std::size_t>(rays) + static_cast<std::size_t>(r)];
          if (hit == kNoTexel) continue;
          const Nodes::Patch& source = nodes.patches[nodes.patch_of[hit]];
          const std::array<double, 3> phi = {1.0, static_cast<double>(nodes.phi[hit].x),
                                             static_cast<double>(nodes.phi[hit].y)};
          for (std::uint32_t a = 0; a < p.count; ++a) {
            for (std::uint32_t b = 0; b < source.count; ++b) {
              rows[a * nodes.functions + source.first + b] += w[a] * phi[b];
            }
          }
        }
      }
      for (std::uint32_t a = 0; a < p.count; ++a) {
        float* out = &nodes.matrix[(p.first + a) * nodes.stride];
        for (std::size_t f = 0; f < nodes.functions; ++f) out[f] = static_cast<float>(rows[a * nodes.functions + f]);
      }
    }
  });
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

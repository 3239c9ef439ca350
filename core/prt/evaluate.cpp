// SPDX-License-Identifier: MIT
#include "core/prt/evaluate.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cassert>

namespace soffit::prt {
namespace {

/// Blocks per task: some 100 kB of halves at 25 coefficients. Smaller ones cost more than they
/// spread.
constexpr std::size_t kGrain = 196;

/// Light times the transfer of consecutive blocks, three channels of each.
void dotRange(const TransferVectors& t, std::size_t begin, std::size_t blocks, std::size_t count,
              const std::array<const float*, 3>& light, const std::array<float*, 3>& values) {
  const transfer::Half* rows = t.blocks().data() + begin * t.blockStride();
  if (t.channels() == 1) {
    dotBlocks(rows, t.blockStride(), blocks, count, 3,
              {{light[0], light[1], light[2]}, {values[0], values[1], values[2]}});
    return;
  }
  for (std::size_t c = 0; c < 3; ++c) {
    dotBlocks(rows + c * t.coefficients() * kBlock, t.blockStride(), blocks, count, 1,
              {{light[c], nullptr, nullptr}, {values[c], nullptr, nullptr}});
  }
}

bool sameShares(const ProbeShares& a, const ProbeShares& b) {
  return a.probe == b.probe && a.weight == b.weight;
}

/// Light of one receiver, mixed from probes.
void mix(std::span<const LightVector> probes, const ProbeShares& shares,
         std::array<std::vector<float>, 3>& light) {
  for (std::size_t c = 0; c < 3; ++c) {
    std::fill(light[c].begin(), light[c].end(), 0.0F);
    for (std::size_t p = 0; p < ProbeShares::kMost; ++p) {
      if (shares.weight[p] == 0.0F) continue;
      const std::vector<float>& from = probes[shares.probe[p]].channels[c];
      for (std::size_t i = 0; i < light[c].size(); ++i) light[c][i] += shares.weight[p] * from[i];
    }
  }
}

}  // namespace

LightVector::LightVector(const sh::RgbCoefficients& coefficients) {
  for (std::size_t c = 0; c < 3; ++c) {
    channels[c].assign(coefficients[c].begin(), coefficients[c].end());
  }
}

LightVector::LightVector(const sh::Coefficients& grey) {
  for (auto& channel : channels) channel.assign(grey.begin(), grey.end());
}

void Illuminances::resize(std::size_t receivers) {
  size = receivers;
  for (auto& channel : channels) channel.resize((receivers + kBlock - 1) / kBlock * kBlock);
}

void evaluate(const TransferVectors& transfer, const LightVector& light, Illuminances& out) {
  out.resize(transfer.size());
  const std::size_t count = std::min(light.size(), transfer.coefficients());
  parallelFor(transfer.blockCount(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::array<const float*, 3> from{};
    std::array<float*, 3> to{};
    for (std::size_t c = 0; c < 3; ++c) {
      from[c] = light.channels[c].data();
      to[c] = out.channels[c].data() + begin * kBlock;
    }
    dotRange(transfer, begin, end - begin, count, from, to);
  });
}

void evaluate(const TransferVectors& transfer, std::span<const float> light, std::span<float> out) {
  assert(out.size() == transfer.blockCount() * kBlock);
  const std::size_t count = std::min(light.size(), transfer.coefficients());
  parallelFor(transfer.blockCount(), kGrain, [&](std::size_t begin, std::size_t end) {
    dotBlocks(transfer.blocks().data() + begin * transfer.blockStride(), transfer.blockStride(),
              end - begin, count, 1,
              {{light.data(), nullptr, nullptr}, {out.data() + begin * kBlock, nullptr, nullptr}});
  });
}

void evaluate(const TransferVectors& transfer, std::span<const LightVector> probes,
              std::span<const ProbeShares> shares, Illuminances& out) {
  assert(shares.size() == transfer.size() && !probes.empty());
  out.resize(transfer.size());
  const std::size_t count = std::min(probes[0].size(), transfer.coefficients());
  parallelFor(transfer.blockCount(), 16, [&](std::size_t begin, std::size_t end) {
    std::array<std::vector<float>, 3> light;
    for (auto& channel : light) channel.resize(probes[0].size());
    for (std::size_t b = begin; b < end; ++b) {
      const std::size_t first = b * kBlock;
      const std::size_t last = std::min(first + kBlock, transfer.size());
      const ProbeShares& lead = shares[first];
      const bool even = std::all_of(shares.begin() + static_cast<std::ptrdiff_t>(first),
                                    shares.begin() + static_cast<std::ptrdiff_t>(last),
                                    [&](const ProbeShares& s) { return sameShares(s, lead); });
      if (even) {
        mix(probes, lead, light);
        dotRange(transfer, b, 1, count, {light[0].data(), light[1].data(), light[2].data()},
                 {&out.channels[0][first], &out.channels[1][first], &out.channels[2][first]});
        continue;
      }
      for (std::size_t k = first; k < last; ++k) {
        mix(probes, shares[k], light);
        for (std::size_t c = 0; c < 3; ++c) {
          float sum = 0.0F;
          for (std::size_t i = 0; i < count; ++i) sum += light[c][i] * transfer.at(k, c, i);
          out.channels[c][k] = sum;
        }
      }
    }
  });
}

}  // namespace soffit::prt

// SPDX-License-Identifier: MIT
#pragma once

#include "core/prt/transfer_vectors.h"

#include "core/math/vec.h"
#include "core/sh/index.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Transfer times light: the dot products that are left of PRT at run time.
namespace soffit::prt {

/// Light coefficients for three channels, n^2 floats each: cd/m^2 sr^1/2, world axes.
struct LightVector {
  LightVector() = default;
  explicit LightVector(const sh::RgbCoefficients& coefficients);
  /// The same light in all three channels.
  explicit LightVector(const sh::Coefficients& grey);
  [[nodiscard]] std::size_t size() const { return channels[0].size(); }
  std::array<std::vector<float>, 3> channels;
};

/// Illuminance by receiver, lux, a list per channel of linear Rec.709: as kernels write it and a
/// vertex buffer takes it. Padded to whole blocks; the first size() numbers count.
struct Illuminances {
  std::size_t size = 0;
  std::array<std::vector<float>, 3> channels;
  void resize(std::size_t receivers);
  [[nodiscard]] vec3 at(std::size_t i) const {
    return {channels[0][i], channels[1][i], channels[2][i]};
  }
};

/// E of every receiver under one light: E_c = sum over i of L_ci T_ci. The fewer of both's bands
/// count. All threads, SIMD; single precision: 1e-6 of sum |L T|. Nothing is clamped: ringing may
/// take E below 0 (sh/window.h keeps it away).
void evaluate(const TransferVectors& transfer, const LightVector& light, Illuminances& out);

/// The same for one channel of light on the first of transfer: luminance alone, a third of the
/// work. out.size() == transfer.size() rounded up to kBlock.
void evaluate(const TransferVectors& transfer, std::span<const float> light, std::span<float> out);

/// Between which probes a receiver's light is interpolated.
struct ProbeShares {
  static constexpr std::size_t kMost = 8;
  std::array<std::uint32_t, kMost> probe{};
  std::array<float, kMost> weight{};  ///< sum to 1; 0 for those not in use
};

/// E of every receiver under light that differs from place to place: that of its zone, or mixed
/// from the probes around it. shares.size() == transfer.size(); probes of equal size. Where a whole
/// block has the same shares its light is mixed once. Continuous where the weights are.
void evaluate(const TransferVectors& transfer, std::span<const LightVector> probes,
              std::span<const ProbeShares> shares, Illuminances& out);

}  // namespace soffit::prt

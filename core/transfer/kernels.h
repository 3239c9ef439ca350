// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/transfer/gather_lists.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>

/// The loops that run on every move, for the widest vector unit at hand (Highway).
namespace soffit::transfer {

/// Up to 16 reflectances that the slots of one cluster share.
struct Palette {
  static constexpr std::size_t kMost = 16;
  std::array<std::array<float, kMost>, 3> rho{};
  std::uint32_t size = 0;  ///< 0: more than kMost (textures)
};

/// Light of a white source as the gather lists take it.
struct TintedLight {
  /// Irradiance per slot; the lowest 4 bits of the float are the slot's place in the palette of its
  /// cluster (an error of 1e-6).
  std::span<const float> lux;
  std::array<std::span<const float>, 3> rho;  ///< per slot
  std::span<const Palette> palettes;          ///< per cluster
  std::span<const std::uint8_t> lit;          ///< per cluster, 0 where lux is 0

  static float pack(float lux, std::uint32_t place) {
    return std::bit_cast<float>((std::bit_cast<std::uint32_t>(lux) & ~15U) | place);
  }
};

/// y[k] = gather list first+k of rho lux, k < y.size(); dark clusters are skipped.
void gatherTinted(const GatherLists& lists, std::size_t first, const TintedLight& light, std::span<vec4> y);

/// y[k] = gather list first+k of x, k < y.size(); x: RGB + padding per slot. lit: per cluster,
/// 0 where x is known to be 0 (those taps are skipped); empty: all.
void gather(const GatherLists& lists, std::size_t first, std::span<const vec4> x, std::span<const std::uint8_t> lit,
            std::span<vec4> y);

/// out_c[s] += sum_k weights[k*slots + s] y[k].c for c = x, y, z; slots a multiple of 16.
void interpolate(std::span<const float> weights, std::span<const vec4> y, std::size_t slots, float* out_r,
                 float* out_g, float* out_b);

/// y[t] += scale * x[t] for t < n.
void addScaled(float scale, const float* x, float* y, std::size_t n);

}  // namespace soffit::transfer

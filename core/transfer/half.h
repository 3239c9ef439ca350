// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace soffit::transfer {

/// A number of IEEE 754 binary16 for bulk storage: 11 significant bits (a relative error of at most
/// 2^-11) from 6.1e-5 to 65504, steps of 6e-8 below.
struct Half {
  std::uint16_t bits = 0;

  constexpr Half() = default;
  /// To nearest, ties to even; what is too large becomes the largest, infinity and NaN stay.
  // Implicit, so that arrays of float are assigned to arrays of Half.
  constexpr Half(float value) : bits(bitsOf(value)) {}
  constexpr operator float() const {
    const std::uint32_t sign = (bits & 0x8000U) << 16U;
    const std::uint32_t exponent = bits & 0x7c00U;
    const std::uint32_t mantissa = bits & 0x3ffU;
    if (exponent == 0) {
      const float small = static_cast<float>(mantissa) * 0x1p-24F;
      return std::bit_cast<float>(std::bit_cast<std::uint32_t>(small) | sign);
    }
    const std::uint32_t rebased =
        exponent == 0x7c00U ? 0x7f800000U : (exponent << 13U) + (112U << 23U);
    return std::bit_cast<float>(sign | rebased | mantissa << 13U);
  }
  [[nodiscard]] constexpr bool finite() const { return (bits & 0x7c00U) != 0x7c00U; }
  friend constexpr bool operator==(Half a, Half b) { return a.bits == b.bits; }

 private:
  static constexpr std::uint16_t bitsOf(float value) {
    std::uint32_t x = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t sign = x >> 16U & 0x8000U;
    x &= 0x7fffffffU;
    if (x >= 0x7f800000U) return static_cast<std::uint16_t>(sign | (x > 0x7f800000U ? 0x7e00U : 0x7c00U));
    if (x >= 0x477ff000U) return static_cast<std::uint16_t>(sign | 0x7bffU);  // from 65520 on
    if (x < 0x38800000U) {
      // Below 2^-14: the sum with 0.5 rounds to steps of 2^-24, the unit of these halves.
      const float moved = std::bit_cast<float>(x) + 0.5F;
      return static_cast<std::uint16_t>(sign | (std::bit_cast<std::uint32_t>(moved) - 0x3f000000U));
    }
    // Another exponent bias (127 - 15 less); half an ulp before the 13 lowest bits go.
    return static_cast<std::uint16_t>(
        sign | (x - (112U << 23U) + 0xfffU + (x >> 13U & 1U)) >> 13U);
  }
};

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// Random numbers whose sequence is part of the program, the same on every platform.
namespace soffit {

/// PCG32 (O'Neill 2014, pcg-random.org, XSH-RR 64/32): small, fast, independent streams.
class Rng {
 public:
  explicit Rng(std::uint64_t seed, std::uint64_t stream = 0) : increment_((stream << 1U) | 1U) {
    next();
    state_ += seed;
    next();
  }
  /// 32 uniform bits.
  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ULL + increment_;
    const auto xored = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    const auto turn = static_cast<std::uint32_t>(old >> 59U);
    return (xored >> turn) | (xored << ((32U - turn) & 31U));
  }
  /// Uniform in [0, 1).
  float uniform() { return static_cast<float>(next() >> 8U) * 0x1p-24F; }
  /// Uniform in [0, 1) with 53 bits.
  double uniformDouble() {
    const std::uint64_t hi = next() >> 5U;
    const std::uint64_t lo = next() >> 6U;
    return static_cast<double>(hi * 67108864U + lo) * 0x1p-53;
  }
  /// Uniform in 0 .. n-1, n >= 1 (Lemire's multiplication; bias below n / 2^32).
  std::uint32_t below(std::uint32_t n) {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(next()) * n) >> 32U);
  }

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

/// A well-mixed 64-bit hash of an integer (SplitMix64's finaliser, Steele et al. 2014).
constexpr std::uint64_t mixBits(std::uint64_t x) {
  x ^= x >> 30U;
  x *= 0xbf58476d1ce4e5b9ULL;
  x ^= x >> 27U;
  x *= 0x94d049bb133111ebULL;
  return x ^ (x >> 31U);
}

}  // namespace soffit

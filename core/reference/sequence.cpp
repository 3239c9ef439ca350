// SPDX-License-Identifier: MIT
#include "core/reference/sequence.h"

#include "core/math/rng.h"

#include <array>
#include <cmath>

namespace soffit::reference {
namespace {

constexpr int kBits = 32;
using Directions = std::array<std::uint32_t, kBits>;

constexpr std::uint32_t reverseBits(std::uint32_t x) {
  x = (x << 16U) | (x >> 16U);
  x = ((x & 0x00ff00ffU) << 8U) | ((x & 0xff00ff00U) >> 8U);
  x = ((x & 0x0f0f0f0fU) << 4U) | ((x & 0xf0f0f0f0U) >> 4U);
  x = ((x & 0x33333333U) << 2U) | ((x & 0xccccccccU) >> 2U);
  return ((x & 0x55555555U) << 1U) | ((x & 0xaaaaaaaaU) >> 1U);
}

/// Direction numbers by Sobol's recurrence for a primitive polynomial of degree s with inner
/// coefficients a and the first s odd integers m.
template <int S>
constexpr Directions directions(unsigned a, const std::array<std::uint32_t, S>& m) {
  Directions v{};
  for (int k = 0; k < kBits; ++k) {
    if (k < S) {
      v[k] = m[k] << static_cast<unsigned>(kBits - 1 - k);
      continue;
    }
    v[k] = v[k - S] ^ (v[k - S] >> static_cast<unsigned>(S));
    for (int j = 1; j < S; ++j) {
      if (((a >> static_cast<unsigned>(S - 1 - j)) & 1U) != 0) v[k] ^= v[k - j];
    }
  }
  return v;
}

/// The exclusive or of the direction numbers of an index's bits, byte by byte.
using Table = std::array<std::array<std::uint32_t, 256>, 4>;

constexpr Table tableOf(const Directions& v) {
  Table table{};
  for (std::size_t byte = 0; byte < 4; ++byte) {
    for (std::uint32_t bits = 0; bits < 256; ++bits) {
      for (std::size_t k = 0; k < 8; ++k) {
        if (((bits >> k) & 1U) != 0) table[byte][bits] ^= v[8 * byte + k];
      }
    }
  }
  return table;
}

constexpr Table kSecond = tableOf(directions<1>(0, {1}));
constexpr Table kThird = tableOf(directions<2>(1, {1, 3}));

std::uint32_t combine(const Table& table, std::uint32_t index) {
  return table[0][index & 255U] ^ table[1][(index >> 8U) & 255U] ^ table[2][(index >> 16U) & 255U] ^
         table[3][index >> 24U];
}

/// A random permutation that respects the binary tree of the leading bits, for reversed bits
/// (Laine & Karras 2011, constants of Burley 2020). The seed is added to all bits: for a uniform
/// seed the result is uniform whatever x.
std::uint32_t laineKarras(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cU;
  x ^= x * 0xb82f1e52U;
  x ^= x * 0xc7afe638U;
  x ^= x * 0x8d22f6e6U;
  return x;
}

std::uint32_t scramble(std::uint32_t x, std::uint32_t seed) {
  return reverseBits(laineKarras(reverseBits(x), seed));
}

std::uint32_t hash(std::uint32_t seed, std::uint32_t dimension) {
  const std::uint64_t key = (static_cast<std::uint64_t>(seed) << 32U) | dimension;
  return static_cast<std::uint32_t>(mixBits(key + 0x9e3779b97f4a7c15ULL) >> 32U);
}

double unit(std::uint32_t x) {
  return static_cast<double>(x) * 0x1p-32;
}

}  // namespace

dvec3 sobolPoint(std::uint32_t i, std::uint32_t seed) {
  // Leading bits decide about the bits below them: the first 2^k indices become, in another
  // order, an aligned block of 2^k of the sequence, which is as well stratified as the first.
  const std::uint32_t index = scramble(i, hash(seed, 0));
  return {unit(scramble(reverseBits(index), hash(seed, 1))),
          unit(scramble(combine(kSecond, index), hash(seed, 2))),
          unit(scramble(combine(kThird, index), hash(seed, 3)))};
}

}  // namespace soffit::reference

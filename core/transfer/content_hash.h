// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// Hashes of content: which bytes are these, and are they still the same? XXH3 (libxxhash), the
/// same on every machine. It guards against accidents, not against forgery.
namespace soffit::transfer {

/// 64 bits: a damaged block passes with probability 2^-64.
std::uint64_t hash64(std::span<const std::byte> bytes);

/// 128 bits, high word first: among n different contents two are equal with probability n^2 2^-129.
std::array<std::uint64_t, 2> hash128(std::span<const std::byte> bytes);

}  // namespace soffit::transfer

// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/operators.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>

/// The form of a stored bake.
///
/// A header (magic, byte order, form, key, size, checksums), a table of blocks (name, place,
/// size, size of a record, checksum), and the blocks: the arrays of Operators as they lie in
/// memory, each at a multiple of 64 bytes, in a fixed order without gaps. Equal operators give
/// equal files.
namespace soffit::transfer {

/// Takes the next bytes of a file; false when they cannot be written.
using ByteSink = std::function<bool(std::span<const std::byte>)>;

/// Writes operators in pieces, front to back. False as soon as the sink says so.
///
/// key  32 characters (cache_key.h).
bool writeOperators(const Operators& operators, std::string_view key, const ByteSink& sink);

/// Operators, or what is wrong with the file: exactly one of the two is there.
struct ReadOperators {
  std::shared_ptr<const Operators> operators;
  std::string trouble;  ///< a clause: "it ends too early"
};

/// Reads and checks everything: form, key, checksum per block, indices (operators_check.h).
///
/// in    at the file's first byte.
/// size  of the file in bytes; no more than about this is allocated whatever the file claims.
ReadOperators readOperators(std::istream& in, std::uint64_t size, std::string_view key);

}  // namespace soffit::transfer

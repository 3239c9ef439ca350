// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/prt/visibility_flags.h"

#include <array>
#include <cstdint>
#include <istream>
#include <ostream>
#include <string>

/// Visibility flags on disk: a header, the bits as they lie in memory, what glass dims, and a
/// checksum. Little endian; a machine of the other order refuses the file by its first number.
namespace soffit::prt {

/// Names what the flags were traced from, so that another scene's are not taken: set keys, edits.
using FlagsKey = std::array<std::uint64_t, 2>;

/// Writes everything; false when the stream fails.
bool writeFlags(const VisibilityFlags& flags, const FlagsKey& key, std::ostream& out);

/// Reads flags written under the same key. Errors: not such a file, another version, another key,
/// too short, damaged (checksum); `place` names the file in the message. size: bytes of the file;
/// no more than about this is allocated whatever the header claims.
Result<VisibilityFlags> readFlags(std::istream& in, std::uint64_t size, const FlagsKey& key,
                                  const std::string& place);

}  // namespace soffit::prt

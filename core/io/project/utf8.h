// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace soffit::io {

/// The length of the well-formed UTF-8 sequence (RFC 3629) at the start of `text`; 0 if none.
std::size_t utf8SequenceLength(std::string_view text);

/// `text` if it is UTF-8, else the same bytes read as Latin-1: what old modelling programs write.
std::string utf8FromUnknown(std::string_view text);

}  // namespace soffit::io

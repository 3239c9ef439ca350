// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/io/photometry/photometric_file.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace soffit::io {

/// What an LM-63 file says before its numbers.
struct IesHeading {
  int year = 1986;  ///< edition: 1986 (no tag), 1991, 1995, 2002, 2019
  std::vector<Keyword> keywords;
  std::string tilt;             ///< value of TILT=: "NONE", "INCLUDE" (capitals), or a file's name
  std::size_t data_offset = 0;  ///< where the numbers start
  std::vector<std::string> warnings;
};

/// Does the text have an LM-63 tag or a TILT= line?
bool looksLikeIes(std::string_view text);

/// Reads tag, keywords ([MORE] joins the line before, [BLOCK] and [ENDBLOCK] group) and TILT=.
/// `text` is without a byte order mark; the first line is 1.
Result<IesHeading> parseIesHeading(std::string_view text, const std::string& name);

}  // namespace soffit::io

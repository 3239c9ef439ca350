// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace soffit::io {

/// A name for a file out of any text (UTF-8): what file systems or shells take amiss becomes "_",
/// and the file is never hidden.
std::string fileNameOf(const std::string& text);

}  // namespace soffit::io

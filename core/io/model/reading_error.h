// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/io/model/child_process.h"

namespace soffit::io {

/// What to tell the user when the process that reads a model came to this end, other than kDone.
Error readingError(ChildEnd end, const std::filesystem::path& file);

}  // namespace soffit::io

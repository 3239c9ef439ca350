// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

/// Where results go: to a file, written whole or not at all, or to stdout.
namespace soffit::cli {

/// Writes to the file, or to stdout when `file` is empty or "-".
/// Errors: the file cannot be written; stdout is full or closed.
Result<void> writeResult(const std::string& file, std::string_view text);

/// Whether writeResult() can be expected to succeed; asked before long work. Errors: no such
/// folder, no permission, a folder of that name.
Result<void> checkResultFile(const std::string& file);

}  // namespace soffit::cli

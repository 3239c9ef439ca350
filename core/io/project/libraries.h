// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/library.h"

#include <vector>

namespace soffit::io {

/// JSON for Modern C++ and {fmt}.
std::vector<Library> textLibraries();

}  // namespace soffit::io

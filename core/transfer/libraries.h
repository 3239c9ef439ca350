// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/library.h"

#include <vector>

namespace soffit::transfer {

/// Eigen, Highway, xxHash.
std::vector<Library> libraries();

}  // namespace soffit::transfer

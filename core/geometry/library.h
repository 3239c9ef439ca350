// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/library.h"

namespace soffit::geometry {

/// Embree.
Library rayLibrary();

}  // namespace soffit::geometry

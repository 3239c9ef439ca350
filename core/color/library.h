// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/library.h"

namespace soffit::color {

/// OpenColorIO.
Library colorLibrary();

}  // namespace soffit::color

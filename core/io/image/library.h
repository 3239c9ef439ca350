// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/library.h"

namespace soffit::io {

/// OpenImageIO.
Library imageLibrary();

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/library.h"

namespace soffit::io {

/// Assimp.
Library modelLibrary();

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/library.h"

namespace soffit::ui {

/// VTK.
Library viewLibrary();

}  // namespace soffit::ui

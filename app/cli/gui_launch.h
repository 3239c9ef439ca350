// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <string>

namespace soffit::cli {

/// Replaces this process by the application `soffit-gui` beside this program; returns only when
/// that fails. `project` is handed on unless it is empty.
Error openApplication(const std::string& project);

}  // namespace soffit::cli

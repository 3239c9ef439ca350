// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/json.h"

namespace soffit::io {

/// The project file as it was read (internal to io_project).
struct ProjectDocument {
  Json root;
};

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/io/model/library.h"

#include <assimp/version.h>

#include <fmt/format.h>

namespace soffit::io {

Library modelLibrary() {
  return {"Assimp",
          fmt::format("{}.{}.{}", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch()),
          "BSD-3-Clause"};
}

}  // namespace soffit::io

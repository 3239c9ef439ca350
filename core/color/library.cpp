// SPDX-License-Identifier: MIT
#include "core/color/library.h"

#include <OpenColorIO/OpenColorIO.h>

namespace soffit::color {

Library colorLibrary() {
  return {"OpenColorIO", OCIO_NAMESPACE::GetVersion(), "BSD-3-Clause"};
}

}  // namespace soffit::color

// SPDX-License-Identifier: MIT
#include "core/base/library.h"

#include <tbb/version.h>

namespace soffit {

Library threadLibrary() {
  return {"oneTBB", TBB_runtime_version(), "Apache-2.0"};
}

}  // namespace soffit

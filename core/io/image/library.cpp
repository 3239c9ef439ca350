// SPDX-License-Identifier: MIT
#include "core/io/image/library.h"

#include <OpenImageIO/imageio.h>

#include <fmt/format.h>

namespace soffit::io {

Library imageLibrary() {
  const int version = OIIO::openimageio_version();  // 20410 is 2.4.10
  return {"OpenImageIO",
          fmt::format("{}.{}.{}", version / 10000, version / 100 % 100, version % 100),
          version >= 20500 ? "Apache-2.0" : "BSD-3-Clause"};
}

}  // namespace soffit::io

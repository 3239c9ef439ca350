// SPDX-License-Identifier: MIT
#include "core/io/project/libraries.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace soffit::io {

std::vector<Library> textLibraries() {
  return {{"JSON for Modern C++",
           fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                       NLOHMANN_JSON_VERSION_PATCH),
           "MIT"},
          {"{fmt}",
           fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100),
           "MIT"}};
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/transfer/libraries.h"

#include <fmt/format.h>
#include <hwy/highway.h>
#include <xxhash.h>
#include <Eigen/Core>

namespace soffit::transfer {

std::vector<Library> libraries() {
  const unsigned xxhash = XXH_versionNumber();
  return {{"Eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION),
           "MPL-2.0"},
          {"Highway", fmt::format("{}.{}.{}", HWY_MAJOR, HWY_MINOR, HWY_PATCH), "Apache-2.0"},
          {"xxHash", fmt::format("{}.{}.{}", xxhash / 10000, xxhash / 100 % 100, xxhash % 100),
           "BSD-2-Clause"}};
}

}  // namespace soffit::transfer

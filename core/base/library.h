// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace soffit {

/// A library that is used: what an About box says of it. Each module answers for those it owns.
struct Library {
  std::string name;
  std::string version;  ///< of what runs; of header-only ones, what was compiled
  std::string licence;  ///< its SPDX identifier
};

/// oneTBB.
Library threadLibrary();

}  // namespace soffit

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// What belongs to the running program.
namespace soffit::cli {

/// The sample projects' files, sorted: of the source tree that the program was built in, or as
/// installed beside it. Empty when there are none.
std::vector<std::string> sampleProjects();

/// "0.1.0-3f2a91c0": the version and a key of the program's own file, so that measurements of two
/// builds are told apart.
std::string programVersion();

}  // namespace soffit::cli

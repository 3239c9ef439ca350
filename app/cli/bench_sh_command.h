// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/session.h"

namespace CLI {
class App;
}

namespace soffit::cli {

/// Adds `soffit bench sh` below `soffit bench`: speed and error of core/sh's methods. (A project
/// folder of that name is reached as ./sh.)
void addBenchShCommand(CLI::App& bench, Session& session);

}  // namespace soffit::cli

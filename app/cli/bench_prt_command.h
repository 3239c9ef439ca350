// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/session.h"

namespace CLI {
class App;
}

namespace soffit::cli {

/// Adds `soffit bench prt` below `soffit bench`: speed and error of core/prt's methods. (A project
/// folder of that name is reached as ./prt.)
void addBenchPrtCommand(CLI::App& bench, Session& session);

}  // namespace soffit::cli

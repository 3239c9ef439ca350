// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/session.h"

namespace CLI {
class App;
}

namespace soffit::cli {

/// Adds `soffit bench growth` below `soffit bench`: times over the size of generated rooms. (A
/// project folder of that name is reached as ./growth.)
void addBenchGrowthCommand(CLI::App& bench, Session& session);

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/session.h"

namespace CLI {
class App;
}

namespace soffit::cli {

/// Adds `soffit bench glossy [P]` below `soffit bench`: speed, memory and error of core/glossy's
/// methods; with a project, its pictures by every method against the path tracer. (A project folder
/// of that name is reached as ./glossy.)
void addBenchGlossyCommand(CLI::App& bench, Session& session);

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/session.h"

namespace CLI {
class App;
}

namespace soffit::cli {

/// Adds `soffit bench papers` below `soffit bench`: the founding papers' figures beside those of
/// this machine on the same kind of work. (A project folder of that name is reached as ./papers.)
void addBenchPapersCommand(CLI::App& bench, Session& session);

}  // namespace soffit::cli

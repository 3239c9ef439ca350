// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/session.h"

#include <vector>

namespace CLI {
class App;
}

/// The subcommands of `soffit`, one file each (NAME_command.cpp).
///
/// Each function adds a subcommand to the application and has its callback set session.run. To
/// add one: declare it here and enter it in commands().
namespace soffit::cli {

void addInfoCommand(CLI::App& app, Session& session);
void addImportCommand(CLI::App& app, Session& session);
void addLuminaireCommand(CLI::App& app, Session& session);
void addMeasureCommand(CLI::App& app, Session& session);
void addMoveCommand(CLI::App& app, Session& session);
void addBakeCommand(CLI::App& app, Session& session);
void addReferenceCommand(CLI::App& app, Session& session);
void addVerifyCommand(CLI::App& app, Session& session);
void addCompareCommand(CLI::App& app, Session& session);
void addBenchCommand(CLI::App& app, Session& session);

using AddCommand = void (*)(CLI::App& app, Session& session);

/// In the order of `soffit --help`.
const std::vector<AddCommand>& commands();

}  // namespace soffit::cli

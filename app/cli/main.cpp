// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/gui_launch.h"
#include "app/cli/interruption.h"
#include "app/cli/session.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <string>

namespace soffit::cli {
namespace {

/// What the exit status tells scripts.
enum ExitStatus { kDone = 0, kWrongInput = 1, kWrongUsage = 2, kInternalFault = 3 };

void printLine(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  fmt::print(stderr, "soffit: {}\n", text);
}

/// Help and version are wishes, everything else that stops the parser is wrong usage.
int reportUsage(const CLI::App& app, const CLI::ParseError& stop) {
  if (stop.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    return app.exit(stop) == 0 ? kDone : kInternalFault;
  }
  printLine(fmt::format("{} (soffit --help tells more)", stop.what()));
  return kWrongUsage;
}

int run(int argc, char** argv) {
  CLI::App app{"Interactive, converged light for indoor architecture", "soffit"};
  app.set_version_flag("--version", "soffit " SOFFIT_VERSION);
  app.set_help_all_flag("--help-all", "Print the help of all subcommands");
  app.require_subcommand(0, 1);
  app.footer("Without a subcommand the application opens, with project P if given.");
  std::string project;
  app.add_option("P", project, "Project to open: a .soffit file, or a folder that holds one");
  Session session;
  for (const AddCommand add : commands()) add(app, session);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return reportUsage(app, stop);
  }
  if (!session.run) {
    printLine(openApplication(project).message());
    return kWrongInput;
  }
  const Interruption interruption(session.stop);
  const Result<void> result = session.run();
  if (!result && interruption.came()) {
    printLine("interrupted; what was not finished is not written");
    interruption.endProgram();
  }
  if (!result) {
    printLine(result.error().message());
    return kWrongInput;
  }
  for (const std::string& warning : session.warnings) printLine("warning: " + warning);
  return kDone;
}

}  // namespace
}  // namespace soffit::cli

int main(int argc, char** argv) {
  try {
    return soffit::cli::run(argc, argv);
  } catch (const std::bad_alloc&) {
    soffit::cli::printLine(
        "internal fault: out of memory. Close other programs or simplify the scene.");
  } catch (const std::exception& fault) {
    soffit::cli::printLine(fmt::format("internal fault: {}. Please report this.", fault.what()));
  } catch (...) {
    soffit::cli::printLine("internal fault. Please report this.");
  }
  return soffit::cli::kInternalFault;
}

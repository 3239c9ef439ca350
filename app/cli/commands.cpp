// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"

#include "app/cli/engine.h"
#include "app/cli/render_command.h"

namespace soffit::cli {

const std::vector<AddCommand>& commands() {
  static const std::vector<AddCommand> list{
      addInfoCommand,
      addImportCommand,
      addLuminaireCommand,
      addBakeCommand,
      addMeasureCommand,
      addReferenceCommand,
      addCompareCommand,
      addVerifyCommand,
      addBenchCommand,
      addMoveCommand,
      [](CLI::App& app, Session& session) {
        addRenderCommand(app, session, pictureLight(session));
      },
  };
  return list;
}

}  // namespace soffit::cli

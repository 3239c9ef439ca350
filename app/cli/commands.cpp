// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"

namespace soffit::cli {

const std::vector<AddCommand>& commands() {
  static const std::vector<AddCommand> list{
      addInfoCommand,
      addImportCommand,
      addLuminaireCommand,
  };
  return list;
}

}  // namespace soffit::cli

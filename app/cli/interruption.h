// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>

namespace soffit::cli {

/// Lets Ctrl-C (SIGINT) and SIGTERM end long work in order: from construction on, the first of
/// them asks the work to stop, the second one ends the program at once. Make one before other
/// threads start; it lasts until the program ends.
class Interruption {
 public:
  explicit Interruption(std::stop_source stop);
  /// Whether such a signal came.
  [[nodiscard]] bool came() const;
  /// Ends the program as the signal would have, so that shells and make see an interruption.
  [[noreturn]] void endProgram() const;
};

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace soffit::cli {

/// What the frame and the subcommands share during one call of the program.
struct Session {
  /// What the chosen subcommand does, set by its callback. It returns an Error when the input is
  /// wrong (exit status 1, one line); exceptions end in status 3.
  std::function<Result<void>()> run;
  /// Lines for stderr once the command succeeded; after a failure stderr has just its one line.
  std::vector<std::string> warnings;
  /// Ctrl-C asks the work to stop.
  std::stop_source stop;

  [[nodiscard]] Job job(ProgressObserver& observer) const { return {&observer, stop.get_token()}; }
};

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "core/base/progress.h"

/// Work that may crash, hang or eat memory, in a process of its own.
///
/// Parsers of foreign formats do all three on damaged files (measured: a third of damaged IFC
/// files crash Assimp 5.2). The child is a fork without exec: it starts at once and needs no
/// program of its own to be found. It must not start threads or take locks that other threads of
/// the parent may hold; the C library's own are safe.
namespace soffit::io {

struct ChildLimits {
  int cpu_seconds = 60;
  std::size_t memory_bytes = 0;  ///< beyond what the parent uses; 0: as much as the machine has
};

enum class ChildEnd {
  kDone,
  kCrashed,    ///< died, or its work threw
  kTimedOut,   ///< used up its time
  kCancelled,  ///< the job was stopped; the child is dead
  kFailed,     ///< could not be started
};

struct ChildOutcome {
  ChildEnd end = ChildEnd::kFailed;
  std::string bytes;  ///< what the work returned, if kDone
};

/// Runs `work` in a child process and waits for the bytes it returns. What the work prints is
/// swallowed; the progress it reports to the Job it is handed arrives at `job`'s observer under
/// `stage`. A stop request is obeyed within some 20 ms by ending the child.
ChildOutcome runInChild(const std::function<std::string(const Job&)>& work,
                        const ChildLimits& limits, const Job& job, const char* stage);

}  // namespace soffit::io

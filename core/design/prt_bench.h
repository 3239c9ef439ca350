// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Time, memory and error of core/prt's methods on the machine at hand.
namespace soffit::design {

struct PrtBenchRow {
  std::string task;    ///< "apply", "shadow pass", ..
  std::string method;  ///< "rgb light", "hammersley", ..
  int bands = 0;
  std::size_t samples = 0;  ///< directions
  std::size_t receivers = 0;
  double ms = 0.0;      ///< of one call: the median where it is repeated
  double cpu_ms = 0.0;  ///< processor time of all threads in one call; other programs do not count
  std::uint64_t rays = 0;
  double megabytes = 0.0;  ///< 10^6 bytes that it leaves in memory
  /// RMS over RMS of the exact illuminances. Exact are, for "apply", floats instead of halves; for
  /// "samples" the same bands with 16,384 directions; for "bands" the same rays without harmonics;
  /// for "places" 16,384 directions at random points of the surfaces, most of them between
  /// receivers. For "bounces" it is the last pass' share of the direct light.
  double rms_error = 0.0;
};

struct PrtBenchOptions {
  std::uint64_t seed = 1;
  std::string only;               ///< a task's name; empty: all
  int side = 256;                 ///< of the large texture, texels; the founding papers' is 1024
  double seconds_per_case = 0.1;  ///< spent on timing each repeated case
  int detail = 1;                 ///< 0: few receivers and directions, for tests
};

/// The tasks' names, in the order in which they are measured.
std::vector<std::string> prtBenchTasks();

/// Measures every case on the threads that are allowed, in a room with a skylight that is made
/// here. Errors: cancelled.
Result<std::vector<PrtBenchRow>> measurePrt(const PrtBenchOptions& options, const Job& job);

/// task,method,bands,samples,receivers,ms,cpu_ms,rays,megabytes,rms_error; a header
/// and a row per element.
std::string formatPrtBenchRows(const std::vector<PrtBenchRow>& rows);

}  // namespace soffit::design

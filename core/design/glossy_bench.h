// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// Speed, memory and error of core/glossy's methods on the machine at hand, on all threads.
namespace soffit::design {

struct GlossyBenchRow {
  std::string task;  ///< "matrices", "clusters", "directions", "highlight", "map"
  std::string method;
  int bands = 0;           ///< 0: none
  std::size_t items = 0;   ///< receivers, lookups or texels that one call handles
  double ms = 0.0;         ///< per call: median of repetitions
  std::size_t bytes = 0;   ///< that the method keeps
  double rms_error = 0.0;  ///< RMS of the error over the RMS of the exact values
};

/// A method ready to be timed and judged.
struct GlossyBenchCase {
  std::string task, method;
  int bands = 0;
  std::size_t items = 0;
  std::size_t bytes = 0;
  std::function<void()> run;
  std::function<double()> error;
};

/// All cases over `receivers` receivers on the ground among boxes (visibility by 400 rays each),
/// with random numbers from `seed`.
std::vector<GlossyBenchCase> glossyBenchCases(std::size_t receivers, std::uint64_t seed);

struct GlossyBenchOptions {
  std::uint64_t seed = 1;
  std::size_t receivers = 25'000;
  double seconds_per_case = 0.3;  ///< spent on timing each; at least three calls
};

/// Times and judges every case. Errors: cancelled.
Result<std::vector<GlossyBenchRow>> measureGlossy(const GlossyBenchOptions& options,
                                                  const Job& job);

/// task,method,bands,items,ms,bytes,rms_error; a header and a row per element.
std::string formatGlossyBenchRows(const std::vector<GlossyBenchRow>& rows);

}  // namespace soffit::design

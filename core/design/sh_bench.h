// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// Speed and error of core/sh's methods on the machine at hand.
namespace soffit::design {

struct ShBenchRow {
  std::string task;    ///< "evaluate", "project", ..
  std::string method;  ///< "recurrence", "stratified", ..
  int bands = 0;
  std::size_t samples = 0;  ///< directions, texels or items that one call handles
  double ns = 0.0;          ///< per item (sample, receiver, product, light): median of repetitions
  double rms_error =
      0.0;  ///< RMS of the coefficients' or values' error over the RMS of the exact ones
};

/// A method ready to be timed and judged.
struct ShBenchCase {
  std::string task, method;
  int bands = 0;
  std::size_t samples = 0;
  std::size_t items = 0;  ///< that one call of `run` handles
  std::function<void()> run;
  std::function<double()> error;
};

/// All cases; their data is made here, with random numbers from `seed`.
std::vector<ShBenchCase> shBenchCases(std::uint64_t seed);

struct ShBenchOptions {
  std::uint64_t seed = 1;
  double seconds_per_case = 0.05;  ///< spent on timing each; at least three calls
};

/// Times and judges every case, one thread. Errors: cancelled.
Result<std::vector<ShBenchRow>> measureSh(const ShBenchOptions& options, const Job& job);

/// task,method,bands,samples,ns,rms_error; a header and a row per element.
std::string formatShBenchRows(const std::vector<ShBenchRow>& rows);

/// RMS of approximate - exact over RMS of exact; of a zero exact value: the plain RMS.
double relativeRms(const std::vector<double>& approximate, const std::vector<double>& exact);

}  // namespace soffit::design

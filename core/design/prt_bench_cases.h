// SPDX-License-Identifier: MIT
#pragma once

#include "core/design/prt_bench.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace soffit::design {

/// The cases of measurePrt(), which add their rows one after another.
class PrtBench {
 public:
  PrtBench(PrtBenchOptions options, Job job) : options_(std::move(options)), job_(std::move(job)) {}

  /// Names and calls, in the order in which they are to run.
  std::vector<std::pair<std::string, std::function<void()>>> cases();
  [[nodiscard]] const std::vector<PrtBenchRow>& rows() const { return rows_; }

 private:
  void apply();
  void samples();
  void bands();
  void bounces();
  void places();
  void texture();

  PrtBenchOptions options_;
  Job job_;
  std::vector<PrtBenchRow> rows_;
};

}  // namespace soffit::design

// SPDX-License-Identifier: MIT
#include "core/design/sh_bench.h"

#include "core/design/median_time.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

namespace soffit::design {

Result<std::vector<ShBenchRow>> measureSh(const ShBenchOptions& options, const Job& job) {
  const std::vector<ShBenchCase> cases = shBenchCases(options.seed);
  std::vector<ShBenchRow> rows;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const ShBenchCase& c = cases[i];
    if (job.cancelled()) return Error{"bench sh", "cancelled", ""};
    job.report(fmt::format("{} {} {}", c.task, c.method, c.bands),
               static_cast<double>(i) / static_cast<double>(cases.size()));
    const double seconds = medianSeconds(c.run, options.seconds_per_case);
    rows.push_back({c.task, c.method, c.bands, c.samples,
                    1e9 * seconds / static_cast<double>(c.items), c.error()});
  }
  return rows;
}

std::string formatShBenchRows(const std::vector<ShBenchRow>& rows) {
  std::string text = "task,method,bands,samples,ns,rms_error\n";
  for (const ShBenchRow& r : rows) {
    text += fmt::format("{},{},{},{},{:.6g},{:.6g}\n", r.task, r.method, r.bands, r.samples, r.ns,
                        r.rms_error);
  }
  return text;
}

double relativeRms(const std::vector<double>& approximate, const std::vector<double>& exact) {
  assert(approximate.size() == exact.size());
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    error += (approximate[i] - exact[i]) * (approximate[i] - exact[i]);
    size += exact[i] * exact[i];
  }
  if (size > 0.0) return std::sqrt(error / size);
  return exact.empty() ? 0.0 : std::sqrt(error / static_cast<double>(exact.size()));
}

}  // namespace soffit::design

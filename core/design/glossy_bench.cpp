// SPDX-License-Identifier: MIT
#include "core/design/glossy_bench.h"

#include "core/design/median_time.h"

#include <fmt/format.h>

namespace soffit::design {

Result<std::vector<GlossyBenchRow>> measureGlossy(const GlossyBenchOptions& options,
                                                  const Job& job) {
  job.report("making receivers", 0.0);
  const std::vector<GlossyBenchCase> cases = glossyBenchCases(options.receivers, options.seed);
  std::vector<GlossyBenchRow> rows;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const GlossyBenchCase& c = cases[i];
    if (job.cancelled()) return Error{"bench glossy", "cancelled", ""};
    job.report(fmt::format("{} {}", c.task, c.method),
               static_cast<double>(i) / static_cast<double>(cases.size()));
    const double seconds = medianSeconds(c.run, options.seconds_per_case);
    rows.push_back({c.task, c.method, c.bands, c.items, 1e3 * seconds, c.bytes, c.error()});
  }
  return rows;
}

std::string formatGlossyBenchRows(const std::vector<GlossyBenchRow>& rows) {
  std::string text = "task,method,bands,items,ms,bytes,rms_error\n";
  for (const GlossyBenchRow& r : rows) {
    text += fmt::format("{},\"{}\",{},{},{:.6g},{},{:.6g}\n", r.task, r.method, r.bands, r.items,
                        r.ms, r.bytes, r.rms_error);
  }
  return text;
}

}  // namespace soffit::design

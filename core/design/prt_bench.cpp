// SPDX-License-Identifier: MIT
#include "core/design/prt_bench.h"

#include "core/design/prt_bench_cases.h"

#include <fmt/format.h>

namespace soffit::design {

std::vector<std::string> prtBenchTasks() {
  std::vector<std::string> names;
  for (const auto& [name, run] : PrtBench({}, {}).cases()) names.push_back(name);
  return names;
}

Result<std::vector<PrtBenchRow>> measurePrt(const PrtBenchOptions& options, const Job& job) {
  PrtBench bench(options, job);
  for (const auto& [name, run] : bench.cases()) {
    if (!options.only.empty() && options.only != name) continue;
    job.report(name, 0.0);
    if (!job.cancelled()) run();
    if (job.cancelled()) return Error{"bench prt", "cancelled", ""};
    job.report(name, 1.0);
  }
  return bench.rows();
}

std::string formatPrtBenchRows(const std::vector<PrtBenchRow>& rows) {
  std::string text = "task,method,bands,samples,receivers,ms,cpu_ms,rays,megabytes,rms_error\n";
  for (const PrtBenchRow& r : rows) {
    text +=
        fmt::format("{},{},{},{},{},{:.6g},{:.6g},{},{:.6g},{:.6g}\n", r.task, r.method, r.bands,
                    r.samples, r.receivers, r.ms, r.cpu_ms, r.rays, r.megabytes, r.rms_error);
  }
  return text;
}

}  // namespace soffit::design

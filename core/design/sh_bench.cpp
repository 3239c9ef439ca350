// SPDX-License-Identifier: MIT
#include "core/design/sh_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

namespace soffit::design {
namespace {

using Clock = std::chrono::steady_clock;

double secondsOf(const std::function<void()>& run, int times) {
  const auto start = Clock::now();
  for (int i = 0; i < times; ++i) run();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Median over batches that are each long enough for the clock (20 microseconds).
double medianSeconds(const std::function<void()>& run, double budget_s) {
  int times = 1;
  double once = secondsOf(run, 1);
  while (once < 2e-5 && times < 1 << 20) {
    times *= 2;
    once = secondsOf(run, times);
  }
  std::vector<double> all;
  for (double spent = 0.0; all.size() < 3 || spent < budget_s;) {
    const double batch = secondsOf(run, times);
    spent += batch;
    all.push_back(batch / times);
  }
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2),
                   all.end());
  return all[all.size() / 2];
}

}  // namespace

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

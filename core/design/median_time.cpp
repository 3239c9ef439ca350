// SPDX-License-Identifier: MIT
#include "core/design/median_time.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace soffit::design {
namespace {

using Clock = std::chrono::steady_clock;

double secondsOf(const std::function<void()>& run, int times) {
  const auto start = Clock::now();
  for (int i = 0; i < times; ++i) run();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

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

}  // namespace soffit::design

// SPDX-License-Identifier: MIT
#include "core/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <mutex>

namespace soffit {
namespace {

struct ThreadLimit {
  std::mutex mutex;
  std::unique_ptr<tbb::global_control> control;
};

ThreadLimit& threadLimit() {
  static ThreadLimit limit;
  return limit;
}

}  // namespace

void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t chunks = (count + grain - 1) / grain;
  if (chunks == 1) {
    body(0, count);
    return;
  }
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t chunk) {
    body(chunk * grain, std::min(count, (chunk + 1) * grain));
  });
}

void parallelInvoke(const std::function<void()>& a, const std::function<void()>& b) {
  tbb::parallel_invoke(a, b);
}

void setThreadCount(int n) {
  ThreadLimit& limit = threadLimit();
  const std::lock_guard lock(limit.mutex);
  limit.control.reset();
  if (n >= 1) {
    limit.control = std::make_unique<tbb::global_control>(
        tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(n));
  }
}

int threadCount() {
  return static_cast<int>(
      std::min<std::size_t>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism),
                            static_cast<std::size_t>(tbb::this_task_arena::max_concurrency())));
}

}  // namespace soffit

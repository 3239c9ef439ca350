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

#ifdef SOFFIT_SANITIZE_THREAD
#include <sanitizer/tsan_interface.h>
#endif

namespace soffit {
namespace {

/// What a loop promises its callers, said to the thread sanitizer, which cannot see into oneTBB
/// (its library is not instrumented, so neither is this file): all that was written before the loop
/// is seen by its bodies, all that they wrote is seen after it. Costs nothing in other builds.
class LoopOrder {
 public:
#ifdef SOFFIT_SANITIZE_THREAD
  LoopOrder() {
    __tsan_release(&begin_);
  }
  ~LoopOrder() {
    __tsan_acquire(&end_);
  }
  void enter() {
    __tsan_acquire(&begin_);
  }
  void leave() {
    __tsan_release(&end_);
  }
#else
  void enter() {}
  void leave() {}
#endif
  void run(const auto& body) {
    enter();
    body();
    leave();
  }

 private:
#ifdef SOFFIT_SANITIZE_THREAD
  char begin_ = 0;
  char end_ = 0;
#endif
};

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
  LoopOrder order;
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t chunk) {
    order.run([&] { body(chunk * grain, std::min(count, (chunk + 1) * grain)); });
  });
}

void parallelInvoke(const std::function<void()>& a, const std::function<void()>& b) {
  LoopOrder order;
  tbb::parallel_invoke([&] { order.run(a); }, [&] { order.run(b); });
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
  return static_cast<int>(std::min<std::size_t>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism),
      static_cast<std::size_t>(tbb::this_task_arena::max_concurrency())));
}

}  // namespace soffit

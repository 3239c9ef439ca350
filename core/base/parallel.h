// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

/// Data-parallel loops (oneTBB behind them).
///
/// Loops hand out index ranges whose bounds do not depend on the thread count, and callers write
/// to disjoint memory or reduce in index order: results are the same for any number of threads.
namespace soffit {

/// Calls body(begin, end) for consecutive ranges of [0, count), each of `grain` indices (the last
/// may be shorter), on all threads. Returns when all are done. body must not throw.
void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Runs two pieces of work at the same time.
void parallelInvoke(const std::function<void()>& a, const std::function<void()>& b);

/// Limits the whole process to n threads, n >= 1; 0 restores the default (all cores).
void setThreadCount(int n);

/// How many threads parallelFor may use at most.
int threadCount();

}  // namespace soffit

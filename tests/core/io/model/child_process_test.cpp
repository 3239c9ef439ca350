// SPDX-License-Identifier: MIT
#include "core/io/model/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <stop_token>
#include <vector>

#include "core/io/model/reading_error.h"

namespace soffit::io {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

ChildOutcome run(const std::function<std::string(const Job&)>& work, const Job& job = {}) {
  return runInChild(work, {.cpu_seconds = 1, .memory_bytes = std::size_t{1} << 28U}, job, "work");
}

TEST(ChildProcess, HandsBackWhatTheWorkReturns) {
  std::string large(3'000'000, 'x');
  large[12345] = '\0';
  const ChildOutcome outcome = run([&](const Job&) { return large; });
  EXPECT_EQ(outcome.end, ChildEnd::kDone);
  EXPECT_EQ(outcome.bytes, large);
  EXPECT_EQ(run([](const Job&) { return std::string(); }).end, ChildEnd::kDone);
}

TEST(ChildProcess, SurvivesCrashesAndExceptions) {
  EXPECT_EQ(run([](const Job&) -> std::string { std::abort(); }).end, ChildEnd::kCrashed);
  EXPECT_EQ(run([](const Job&) -> std::string { throw std::runtime_error("no"); }).end,
            ChildEnd::kCrashed);
  EXPECT_EQ(run([](const Job&) -> std::string { std::_Exit(0); }).end, ChildEnd::kCrashed);
}

TEST(ChildProcess, EndsWhatDoesNotEnd) {
  const ChildOutcome outcome = run([](const Job&) -> std::string {
    for (std::atomic<unsigned> i = 0;;) ++i;
  });
  EXPECT_EQ(outcome.end, ChildEnd::kTimedOut);
}

TEST(ChildProcess, LimitsMemory) {
  const ChildOutcome outcome = run([](const Job&) {
    std::vector<char> block(std::size_t{1} << 40U);
    volatile char* const touched = block.data();  // or a compiler may do without the block
    touched[5] = 'x';
    return std::string(1, touched[5]);
  });
  EXPECT_EQ(outcome.end, ChildEnd::kCrashed);
}

TEST(ChildProcess, StopsOnRequest) {
  std::stop_source source;
  struct Stopper : ProgressObserver {
    void onProgress(std::string_view, double) override { source->request_stop(); }
    std::stop_source* source = nullptr;
  } stopper;
  stopper.source = &source;
  const ChildOutcome outcome = run(
      [](const Job& job) -> std::string {
        job.report("", 0.5);
        for (std::atomic<unsigned> i = 0;;) ++i;
      },
      Job{.observer = &stopper, .stop = source.get_token()});
  EXPECT_EQ(outcome.end, ChildEnd::kCancelled);
}

TEST(ChildProcess, PassesProgressOn) {
  struct Listener : ProgressObserver {
    void onProgress(std::string_view stage, double done) override {
      EXPECT_EQ(stage, "work");
      last = done;
    }
    double last = -1.0;
  } listener;
  run(
      [](const Job& job) {
        for (const double share : {0.0, 0.25, 7.0, 0.75}) job.report("", share);
        return std::string();
      },
      Job{.observer = &listener});
  EXPECT_DOUBLE_EQ(listener.last, 0.75);
}

TEST(ChildProcess, WhatItPrintsIsSwallowed) {
  ::testing::internal::CaptureStderr();
  run([](const Job&) {
    std::fputs("noise", stderr);
    return std::string();
  });
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), IsEmpty());
}

TEST(ReadingError, NamesTheFileAndARemedy) {
  const auto message = [](ChildEnd end) { return readingError(end, "a/b.ifc").message(); };
  EXPECT_THAT(message(ChildEnd::kCrashed),
              ::testing::AllOf(HasSubstr("a/b.ifc: is damaged: its reader failed"),
                               HasSubstr("Export the model again")));
  EXPECT_THAT(message(ChildEnd::kTimedOut), HasSubstr("did not come to an end"));
  EXPECT_THAT(message(ChildEnd::kFailed), HasSubstr("no process could be started"));
  EXPECT_THAT(message(ChildEnd::kCancelled), HasSubstr("cancelled"));
}

}  // namespace
}  // namespace soffit::io

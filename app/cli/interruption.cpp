// SPDX-License-Identifier: MIT
#include "app/cli/interruption.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <thread>
#include <utility>

namespace soffit::cli {
namespace {

std::atomic<int> g_signal{0};

sigset_t endingSignals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

[[noreturn]] void endBy(int signal) {
  std::signal(signal, SIG_DFL);
  const sigset_t set = endingSignals();
  ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  ::raise(signal);
  ::_exit(128 + signal);  // who ignores the signal still ends
}

void watch(std::stop_source& stop) {
  const sigset_t set = endingSignals();
  int signal = 0;
  if (::sigwait(&set, &signal) != 0) return;
  g_signal = signal;
  stop.request_stop();
  if (::sigwait(&set, &signal) == 0) endBy(signal);
}

}  // namespace

Interruption::Interruption(std::stop_source stop) {
  // Blocked here and so in every thread to come; only the watcher takes them.
  const sigset_t set = endingSignals();
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  std::thread([stop = std::move(stop)]() mutable { watch(stop); }).detach();
}

bool Interruption::came() const {
  return g_signal != 0;
}

void Interruption::endProgram() const {
  endBy(g_signal);
}

}  // namespace soffit::cli

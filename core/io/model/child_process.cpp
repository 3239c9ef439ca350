// SPDX-License-Identifier: MIT
#include "core/io/model/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace soffit::io {
namespace {

class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  void reset(int fd) {
    close();
    fd_ = fd;
  }
  void close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }
  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

bool writeAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

// The shared file begins with this and the size of what follows, written last: a child that dies
// on the way leaves no valid result, whatever its exit status says.
struct Header {
  std::uint64_t magic = 0;
  std::uint64_t size = 0;
};
constexpr std::uint64_t kMagic = 0x736f66666974696dULL;

// Passes progress to the parent, a byte of percent each.
class PipeObserver : public ProgressObserver {
 public:
  explicit PipeObserver(int fd) : fd_(fd) {}
  void onProgress(std::string_view /*stage*/, double done) override {
    const auto percent = static_cast<char>(100.0 * std::clamp(done, 0.0, 1.0));
    if (percent == last_) return;
    last_ = percent;
    writeAll(fd_, {&percent, 1});
  }

 private:
  int fd_;
  char last_ = -1;
};

std::size_t addressSpaceInUse() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

std::size_t machineMemory() {
  return static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void confine(const ChildLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGTERM, SIGXCPU}) {
    std::signal(signal, SIG_DFL);
  }
  const auto limit = [](__rlimit_resource what, std::size_t value) {
    const rlimit both{value, value};
    ::setrlimit(what, &both);
  };
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<std::size_t>(limits.cpu_seconds));
  const std::size_t memory = limits.memory_bytes > 0 ? limits.memory_bytes : machineMemory();
  const std::size_t in_use = addressSpaceInUse();
  constexpr std::size_t kSanitizers = std::size_t{1} << 43U;  // they reserve terabytes up front
  if (in_use < kSanitizers) limit(RLIMIT_AS, in_use + memory);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) {
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }
}

[[noreturn]] void beChild(const std::function<std::string(const Job&)>& work,
                          const ChildLimits& limits, int result, int progress) {
  confine(limits);
  try {
    PipeObserver observer(progress);
    const std::string bytes = work(Job{.observer = &observer});
    if (::lseek(result, sizeof(Header), SEEK_SET) < 0 || !writeAll(result, bytes)) ::_exit(2);
    const Header header{kMagic, bytes.size()};
    if (::pwrite(result, &header, sizeof header, 0) != sizeof header) ::_exit(2);
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);  // no destructors, no atexit: those belong to the parent
}

// Reads progress until the child closes its end; false if the job was stopped before that.
bool follow(int progress, const Job& job, const char* stage) {
  constexpr int kPatienceMs = 20;
  for (;;) {
    if (job.cancelled()) return false;
    pollfd waiting{progress, POLLIN, 0};
    if (::poll(&waiting, 1, kPatienceMs) <= 0) continue;
    std::array<char, 64> percent{};
    const ssize_t n = ::read(progress, percent.data(), percent.size());
    if (n == 0 || (n < 0 && errno != EINTR)) return true;
    if (n > 0) job.report(stage, 0.01 * percent[static_cast<std::size_t>(n - 1)]);
  }
}

bool readResult(int fd, std::string& bytes) {
  Header header;
  if (::pread(fd, &header, sizeof header, 0) != sizeof header || header.magic != kMagic) {
    return false;
  }
  bytes.resize(header.size);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::pread(fd, bytes.data() + done, bytes.size() - done,
                              static_cast<off_t>(sizeof header + done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

int waitFor(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

ChildOutcome runInChild(const std::function<std::string(const Job&)>& work,
                        const ChildLimits& limits, const Job& job, const char* stage) {
  const Descriptor result(::memfd_create("soffit-child", MFD_CLOEXEC));
  std::array<int, 2> ends{-1, -1};
  if (result.get() < 0 || ::pipe2(ends.data(), O_CLOEXEC) != 0) return {};
  const Descriptor progress(ends[0]);
  Descriptor child_progress(ends[1]);
  const pid_t child = ::fork();
  if (child < 0) return {};
  if (child == 0) beChild(work, limits, result.get(), child_progress.get());
  child_progress.close();
  const bool followed = follow(progress.get(), job, stage);
  if (!followed) ::kill(child, SIGKILL);
  const int status = waitFor(child);
  if (!followed) return {.end = ChildEnd::kCancelled};
  ChildOutcome out;
  if (readResult(result.get(), out.bytes)) {
    out.end = ChildEnd::kDone;
  } else {
    const bool slow =
        WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
    out.end = slow ? ChildEnd::kTimedOut : ChildEnd::kCrashed;
  }
  return out;
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/io/image/memory_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>

namespace soffit::io {
namespace {

/// All bytes of one descriptor to another; errno or 0.
int copyAll(int from, int to) {
  std::array<char, 1U << 16U> block{};
  off_t place = 0;
  for (;;) {
    const ssize_t got = ::pread(from, block.data(), block.size(), place);
    if (got == 0) return 0;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return errno;
    for (ssize_t done = 0; done < got;) {
      const ssize_t put = ::write(to, block.data() + done, static_cast<std::size_t>(got - done));
      if (put < 0 && errno == EINTR) continue;
      if (put < 0) return errno;
      done += put;
    }
    place += got;
  }
}

}  // namespace

MemoryFile::MemoryFile() : descriptor_(::memfd_create("soffit-picture", MFD_CLOEXEC)) {}

MemoryFile::~MemoryFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::filesystem::path MemoryFile::path() const {
  if (descriptor_ < 0) return {};
  return "/proc/self/fd/" + std::to_string(descriptor_);
}

bool MemoryFile::endsWith(std::string_view tail) const {
  std::string found(tail.size(), '\0');
  const off_t size = ::lseek(descriptor_, 0, SEEK_END);
  const auto count = static_cast<off_t>(tail.size());
  return size >= count &&
         ::pread(descriptor_, found.data(), found.size(), size - count) == ssize_t{count} &&
         found == tail;
}

int MemoryFile::copyTo(const std::filesystem::path& target) const {
  if (descriptor_ < 0) return EBADF;
  const int to = ::open(target.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (to < 0) return errno;
  int trouble = copyAll(descriptor_, to);
  if (trouble == 0 && ::fsync(to) != 0) trouble = errno;
  if (::close(to) != 0 && trouble == 0) trouble = errno;
  if (trouble != 0) ::unlink(target.c_str());
  return trouble;
}

}  // namespace soffit::io

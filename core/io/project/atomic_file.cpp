// SPDX-License-Identifier: MIT
#include "core/io/project/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace soffit::io {
namespace fs = std::filesystem;
namespace {

Error systemError(const fs::path& path, const char* what, int code) {
  return {path.string(), fmt::format("{}: {}", what, std::generic_category().message(code)),
          "Check that the folder exists, may be written and has space."};
}

/// A new file with a name of its own beside `target`; removed again unless renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) {
    static std::atomic<unsigned> serial{0};
    do {
      name_ = fmt::format("{}.{}-{}.tmp", target.string(), ::getpid(), serial++);
      descriptor_ = ::open(name_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    exists_ = descriptor_ >= 0;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (exists_) ::unlink(name_.c_str());
  }

  [[nodiscard]] bool valid() const { return descriptor_ >= 0; }

  /// Returns errno, 0 when all went well.
  int write(std::string_view content, std::optional<mode_t> mode) {
    while (!content.empty()) {
      const ssize_t count = ::write(descriptor_, content.data(), content.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) return errno;
      content.remove_prefix(static_cast<std::size_t>(count));
    }
    if (mode && ::fchmod(descriptor_, *mode) != 0) return errno;
    if (::fsync(descriptor_) != 0) return errno;
    const int closed = ::close(std::exchange(descriptor_, -1));
    return closed == 0 ? 0 : errno;
  }
  int renameTo(const fs::path& target) {
    if (std::rename(name_.c_str(), target.c_str()) != 0) return errno;
    exists_ = false;
    return 0;
  }

 private:
  std::string name_;
  int descriptor_ = -1;
  bool exists_ = false;
};

/// Has the folder's own entry reach the disk; a file system that cannot is no fault of the file.
void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

Result<void> replaceFile(const fs::path& target, std::string_view content,
                         std::optional<mode_t> mode) {
  TemporaryFile file(target);
  if (!file.valid()) return systemError(target, "the file cannot be written", errno);
  if (const int code = file.write(content, mode)) {
    return systemError(target, "the file cannot be written", code);
  }
  if (const int code = file.renameTo(target)) {
    return systemError(target, "the file cannot be replaced", code);
  }
  return {};
}

/// To a device or a pipe, which cannot be replaced.
Result<void> writeStream(const fs::path& target, std::string_view content) {
  std::ofstream stream(target, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  if (!stream.flush()) return systemError(target, "the content cannot be written", errno);
  return {};
}

}  // namespace

Result<void> writeFileAtomically(const fs::path& path, std::string_view content,
                                 Previous previous) {
  std::error_code ignored;
  fs::path target = path;
  if (fs::is_symlink(path, ignored)) {
    std::error_code code;
    target = fs::weakly_canonical(path, code);
    if (code) return systemError(path, "the link cannot be followed", code.value());
  }
  struct stat status {};
  const bool exists = ::stat(target.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    return Error{path.string(), "this is a folder, not a file", "Name a file."};
  }
  if (exists && !S_ISREG(status.st_mode)) return writeStream(target, content);
  std::optional<mode_t> mode;
  if (exists) mode = status.st_mode & 07777U;
  if (exists && previous == Previous::kept_as_backup) {
    const auto old = readFile(target);
    if (!old) return old.error();
    if (auto kept = replaceFile(target.string() + "~", *old, mode); !kept) return kept;
  }
  if (auto written = replaceFile(target, content, mode); !written) return written;
  syncFolder(target.has_parent_path() ? target.parent_path() : fs::path("."));
  return {};
}

Result<std::string> readFile(const fs::path& path, std::size_t most_bytes) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) {
    return Error{path.string(), "there is no such file", "Check the name."};
  }
  if (fs::is_directory(status)) {
    return Error{path.string(), "this is a folder, not a file", "Name a file."};
  }
  std::ifstream stream(path, std::ios::binary);
  std::string content;
  char block[1U << 16U];
  while (stream.read(block, sizeof block) || stream.gcount() > 0) {
    content.append(block, static_cast<std::size_t>(stream.gcount()));
    if (content.size() <= most_bytes) continue;
    return Error{path.string(), fmt::format("the file is larger than {} MB", most_bytes >> 20U),
                 "This cannot be what is asked for; check the name."};
  }
  if (!stream.eof()) {
    return Error{path.string(), "the file cannot be read", "Check its permissions."};
  }
  return content;
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "app/cli/output.h"

#include "core/io/project/atomic_file.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <system_error>

namespace soffit::cli {
namespace fs = std::filesystem;
namespace {

bool isStdout(const std::string& file) {
  return file.empty() || file == "-";
}

}  // namespace

Result<void> writeResult(const std::string& file, std::string_view text) {
  if (!isStdout(file)) return io::writeFileAtomically(file, text);
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    return Error{"standard output", "the result cannot be written",
                 "Check that the disk has space, or write to a file with -o."};
  }
  return {};
}

Result<void> checkResultFile(const std::string& file) {
  if (isStdout(file)) return {};
  const fs::path path(file);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    return Error{file, "this is a folder, not a file", "Name a file."};
  }
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) {
    return Error{file, "there is no folder " + folder.string(), "Make it first."};
  }
  if (::access(folder.c_str(), W_OK) != 0) {
    return Error{file, "the folder " + folder.string() + " may not be written", "Choose another."};
  }
  return {};
}

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace soffit::io {

/// A file in memory for encoders that write to a path and do not notice a full disk (libpng,
/// libjpeg): they write here, and what they wrote is copied with every call checked.
class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// Where to write; a path of this process alone. Empty when there is no memory for it.
  [[nodiscard]] std::filesystem::path path() const;
  /// Whether the content ends with these bytes.
  [[nodiscard]] bool endsWith(std::string_view tail) const;
  /// Copies all of it into a new file, on the disk when this returns. Returns errno, 0 when all
  /// went well; after a failure there is none. EEXIST when there is one already.
  [[nodiscard]] int copyTo(const std::filesystem::path& target) const;

 private:
  int descriptor_ = -1;
};

}  // namespace soffit::io

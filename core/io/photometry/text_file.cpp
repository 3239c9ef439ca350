// SPDX-License-Identifier: MIT
#include "core/io/photometry/text_file.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

namespace soffit::io {
namespace fs = std::filesystem;

Result<std::string> loadText(const fs::path& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) {
    return Error{path.string(), "expected a photometric file, found no file of that name",
                 "Check the path."};
  }
  if (!fs::is_regular_file(status)) {
    return Error{path.string(), "expected a photometric file, found a folder or a device",
                 "Name an .ies or .ldt file."};
  }
  const auto bytes = fs::file_size(path, code);
  if (!code && bytes > kMaxTextBytes) {
    return Error{path.string(),
                 fmt::format("expected at most {} bytes, found {}", kMaxTextBytes, bytes),
                 "This is no photometric file."};
  }
  std::ifstream in(path, std::ios::binary);
  std::string text(code ? 0 : static_cast<std::size_t>(bytes), '\0');
  if (in && !code) in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!in || code) {
    return Error{path.string(), "expected a readable file, found that it cannot be opened",
                 "Check its permissions."};
  }
  return text;
}

Result<void> saveText(const fs::path& path, std::string_view text) {
  fs::path temporary = path;
  temporary += ".part";
  std::error_code code;
  {
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.close();
    if (!out) code = std::make_error_code(std::errc::io_error);
  }
  if (!code) fs::rename(temporary, path, code);
  if (!code) return {};
  std::error_code ignored;
  fs::remove(temporary, ignored);
  return Error{path.string(), "the file cannot be written",
               "Check that the folder exists, may be written to and has room."};
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/io/model/ply_header.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <system_error>

namespace soffit::io {

std::string plyHeaderProblem(const std::filesystem::path& file) {
  constexpr std::size_t kLongest = 65536;
  std::ifstream stream(file, std::ios::binary);
  std::string head(kLongest, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(kLongest));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  if (!head.starts_with("ply")) return "does not begin with 'ply'";
  std::error_code ignored;
  const std::uintmax_t size = std::filesystem::file_size(file, ignored);
  // Lines may end in CR LF, LF or CR.
  for (char& c : head) {
    if (c == '\r') c = '\n';
  }
  std::istringstream lines(head);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "end_header") return {};
    if (key != "element") continue;
    std::string name;
    std::int64_t count = -1;
    if (!(words >> name >> count) || count < 0 || static_cast<std::uintmax_t>(count) > size) {
      return fmt::format("announces an impossible number of elements '{}'", name);
    }
  }
  return "has a header without 'end_header'";
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/io/model/model_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace soffit::io {
namespace fs = std::filesystem;
namespace {

std::string withoutPercents(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    if (text[i] == '%' && i + 2 < text.size()) {
      const char* end = text.data() + i + 3;
      const auto [stop, error] = std::from_chars(text.data() + i + 1, end, code, 16);
      if (error == std::errc() && stop == end && code != 0) {
        out.push_back(static_cast<char>(code));
        i += 2;
        continue;
      }
    }
    out.push_back(text[i]);
  }
  return out;
}

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

}  // namespace

bool liesInFolder(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::path inner = fs::weakly_canonical(path, error);
  if (error) return false;
  const fs::path outer = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error) return false;
  const auto [left, unused] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  static_cast<void>(unused);
  return left == outer.end();
}

TexturePath findTexture(std::string_view name, const fs::path& model, const fs::path& folder) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '\\', '/');
  const fs::path beside = model.parent_path();
  bool outside = false;
  for (const std::string& spelling : {text, withoutPercents(text)}) {
    const fs::path given(spelling);
    for (const fs::path& candidate : {beside / given, beside / given.filename()}) {
      if (given.filename().empty() || !isFile(candidate)) continue;
      if (!liesInFolder(candidate, folder)) {
        outside = true;
        continue;
      }
      std::error_code error;
      const fs::path relative =
          fs::relative(candidate, beside.empty() ? fs::path(".") : beside, error);
      if (!error) return {relative.generic_string(), {}};
    }
  }
  const char* reason = outside ? "lies outside of the project's folder" : "does not exist";
  return {{}, fmt::format("texture '{}' {}, so its surfaces keep their plain color", name, reason)};
}

}  // namespace soffit::io

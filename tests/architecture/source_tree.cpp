// SPDX-License-Identifier: MIT
#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace soffit::architecture {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFolders{"app", "core", "ui", "projects", "resources", "tests", "packaging"};
constexpr std::array kExtensions{".cpp", ".h", ".hpp", ".inl", ".glsl", ".cmake", ".py", ".sh"};

bool isSource(const fs::path& path) {
  const std::string extension = path.extension().string();
  return path.filename() == "CMakeLists.txt" ||
         std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

SourceFile readSource(const fs::path& root, const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {path.lexically_relative(root).generic_string(),
          {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}};
}

/// Block comments become blanks, line breaks stay, so that line numbers hold.
std::string withoutBlockComments(std::string_view text) {
  std::string out(text);
  for (std::size_t begin = out.find("/*"); begin != std::string::npos;
       begin = out.find("/*", begin)) {
    const std::size_t end = std::min(out.find("*/", begin + 2), out.size() - 2) + 2;
    std::replace_if(
        out.begin() + static_cast<std::ptrdiff_t>(begin),
        out.begin() + static_cast<std::ptrdiff_t>(end), [](char c) { return c != '\n'; }, ' ');
  }
  return out;
}

}  // namespace

std::vector<Include> includesOf(std::string_view text) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  std::vector<Include> includes;
  std::istringstream lines(withoutBlockComments(text));
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::smatch match;
    if (std::regex_search(line, match, pattern)) {
      includes.push_back({.path = match[2], .angle = match[1] == "<", .line = number});
    }
  }
  return includes;
}

std::size_t lineCount(std::string_view text) {
  const auto breaks = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  return breaks + (text.empty() || text.back() == '\n' ? 0 : 1);
}

std::string moduleOf(std::string_view path) {
  const std::size_t first = path.find('/');
  if (first == std::string_view::npos) return "";
  const std::string_view top = path.substr(0, first);
  if (top == "app" || top == "tests") return std::string(top);
  if (top != "core" && top != "ui") return "";
  const std::size_t second = path.find('/', first + 1);
  return std::string(path.substr(0, second == std::string_view::npos ? first : second));
}

std::vector<SourceFile> readSources(const fs::path& root) {
  std::vector<SourceFile> files{readSource(root, root / "CMakeLists.txt")};
  for (const char* folder : kFolders) {
    if (!fs::is_directory(root / folder)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.is_regular_file() && isSource(entry.path())) {
        files.push_back(readSource(root, entry.path()));
      }
    }
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

}  // namespace soffit::architecture

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// The project's own source files, as the architecture tests read them.
namespace soffit::architecture {

struct Include {
  std::string path;    ///< as written between the quotes or angle brackets
  bool angle = false;  ///< <path> rather than "path"
  std::size_t line = 0;

  bool operator==(const Include&) const = default;
};

struct SourceFile {
  std::string path;  ///< from the repository root, with slashes
  std::string text;
};

/// The includes of a C++ text, comments left out.
std::vector<Include> includesOf(std::string_view text);

/// Lines of a text; a last line without a line break counts.
std::size_t lineCount(std::string_view text);

/// "core/light" for a file of core, "ui/panels" for one of ui, "app" or "tests" for files below those,
/// else "".
std::string moduleOf(std::string_view path);

/// C++, CMake, Python and shell files below app, core, ui, projects, resources, tests, packaging,
/// and the CMakeLists.txt at the root; sorted by path.
std::vector<SourceFile> readSources(const std::filesystem::path& root);

}  // namespace soffit::architecture

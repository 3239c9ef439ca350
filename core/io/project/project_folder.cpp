// SPDX-License-Identifier: MIT
#include "core/io/project/project_folder.h"

#include "core/io/project/project.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

namespace soffit::io {
namespace fs = std::filesystem;
namespace {

Error leaves(const std::string& file) {
  return {"", fmt::format("\"{}\" leaves the project's folder", file),
          "Copy the file beside the project and name it there."};
}

bool isInside(const fs::path& folder, const fs::path& file) {
  const auto [in_folder, in_file] =
      std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return in_folder == folder.end() && in_file != file.end();
}

}  // namespace

fs::path folderOf(const fs::path& project) {
  return project.has_parent_path() ? project.parent_path() : fs::path(".");
}

Result<fs::path> fileInFolder(const fs::path& folder, const std::string& file) {
  const fs::path name(file);
  if (file.empty() || file.find('\0') != std::string::npos) {
    return Error{"", "the name of the file is empty", "Name a file beside the project."};
  }
  if (name.is_absolute()) return leaves(file);
  const fs::path normal = name.lexically_normal();
  if (normal.begin() != normal.end() && *normal.begin() == "..") return leaves(file);
  std::error_code code;
  const fs::path home = fs::canonical(folder, code);
  if (code) return Error{"", fmt::format("the folder {} cannot be read", folder.string()), ""};
  const fs::path target = fs::canonical(home / name, code);
  if (code) {
    const bool backslash = file.find('\\') != std::string::npos;
    return Error{"", fmt::format("there is no file \"{}\"", file),
                 backslash ? "Write forward slashes in the name."
                           : "Put it beside the project, or correct the name."};
  }
  if (!isInside(home, target)) return leaves(file);
  if (!fs::is_regular_file(target, code)) {
    return Error{"", fmt::format("\"{}\" is not a file", file), "Name a file."};
  }
  return target;
}

Result<fs::path> findProjectFile(const fs::path& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) {
    return Error{path.string(), "there is no such project", "Check the name."};
  }
  if (!fs::is_directory(status)) {
    if (fs::is_regular_file(status)) return path;
    return Error{path.string(), "this is not a file", "Name a .soffit file or its folder."};
  }
  std::vector<fs::path> projects;
  fs::directory_iterator entries(path, code);
  for (; !code && entries != fs::directory_iterator(); entries.increment(code)) {
    if (entries->path().extension() == ".soffit") projects.push_back(entries->path());
  }
  if (code) return Error{path.string(), "the folder cannot be read", "Check its permissions."};
  if (projects.size() == 1) return projects.front();
  if (projects.empty()) {
    return Error{path.string(), "the folder holds no .soffit file", "Name the project file."};
  }
  return Error{path.string(), fmt::format("the folder holds {} .soffit files", projects.size()),
               "Name the one that is meant."};
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "app/cli/gui_launch.h"

#include "core/io/project/project.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

namespace soffit::cli {
namespace fs = std::filesystem;

Error openApplication(const std::string& project) {
  if (!project.empty()) {
    const auto file = io::findProjectFile(project);
    if (!file) {
      Error error = file.error();
      if (!fs::exists(project)) {
        error.what = "there is no such project, and no such subcommand";
        error.hint = "Check the name; soffit --help lists the subcommands.";
      }
      return error;
    }
  }
  std::error_code code;
  const fs::path self = fs::read_symlink("/proc/self/exe", code);
  const fs::path application = (code ? fs::path() : self.parent_path()) / "soffit-gui";
  std::string name = application.string();
  std::string argument = project;
  char* arguments[] = {name.data(), project.empty() ? nullptr : argument.data(), nullptr};
  ::execv(name.c_str(), arguments);
  code = {errno, std::generic_category()};
  return {name, fmt::format("the application cannot be started: {}", code.message()),
          "Build or install soffit-gui, or use a subcommand (soffit --help)."};
}

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
// The application `soffit-gui`.
#include "ui/main_window/application.h"

#include <cstdio>
#include <cstdlib>

namespace {

bool isSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

int main(int argc, char** argv) {
  // Without a display Qt would abort with a page of advice on plugins.
  if (!isSet("DISPLAY") && !isSet("WAYLAND_DISPLAY") && !isSet("QT_QPA_PLATFORM")) {
    std::fputs(
        "soffit: there is no display to open a window on. Use a subcommand "
        "(soffit --help), or log in to a desktop.\n",
        stderr);
    return 1;
  }
  return soffit::ui::runApplication(argc, argv, SOFFIT_VERSION);
}

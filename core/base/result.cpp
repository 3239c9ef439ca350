// SPDX-License-Identifier: MIT
#include "core/base/result.h"

namespace soffit {

std::string Error::message() const {
  std::string line = place.empty() ? what : place + ": " + what;
  if (!hint.empty()) {
    if (!line.empty() && line.back() != '.') line += '.';
    line += ' ';
    line += hint;
  }
  // One line, whatever a third party put into its texts.
  for (char& c : line) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return line;
}

}  // namespace soffit

// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/photometry/ies_reader.h"

#include <string>

namespace soffit::io {

/// An IES file piece by piece; the defaults are 10 cd over the lower hemisphere, 20π lm.
struct IesText {
  std::string head = "IESNA:LM-63-2002\n[LUMINAIRE] Test\n";
  std::string tilt = "TILT=NONE\n";
  std::string lamps = "1 -1 1";  ///< lamps, lumens per lamp, multiplier
  std::string counts = "3 1";
  std::string type = "1";
  std::string size = "2 0 0 0";  ///< units, width, length, height
  std::string factors = "1 1 5";
  std::string vertical = "0 45 90";
  std::string horizontal = "0";
  std::string candela = "10 10 10";
  std::string tail = "\n";

  [[nodiscard]] std::string str() const {
    return head + tilt + lamps + ' ' + counts + ' ' + type + ' ' + size + '\n' + factors + '\n' +
           vertical + '\n' + horizontal + '\n' + candela + tail;
  }
  [[nodiscard]] Result<PhotometricFile> parse() const { return parseIes(str(), "lamp.ies"); }
  /// The message of the error that parsing must end in.
  [[nodiscard]] std::string error() const {
    const auto file = parse();
    return file ? "no error" : file.error().message();
  }
};

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/io/image/file_name.h"

namespace soffit::io {

std::string fileNameOf(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       static_cast<unsigned char>(c) >= 0x80U ||
                       std::string(" -_.+()").find(c) != std::string::npos;
    out += plain ? c : '_';
  }
  // A leading dot would hide the file.
  if (out.empty() || out[0] == '.') out = "_" + out;
  return out;
}

}  // namespace soffit::io

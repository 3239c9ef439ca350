// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/photometry/ldt_reader.h"

#include <string>
#include <vector>

namespace soffit::io {

/// A EULUMDAT file field by field; the defaults are 10 cd per 1000 lm all over the lower
/// hemisphere at 1000 lm, 20π lm.
struct LdtText {
  std::vector<std::string> head{
      "Maker", "1",  "1",   "1",   "0", "3",  "45", "R1", "Lamp", "L1", "lamp.ldt", "2024", "600",
      "300",   "50", "580", "280", "0", "10", "0",  "20", "100",  "80", "1",        "0"};
  std::vector<std::string> sets{"1"};
  std::vector<std::string> set{"1", "LED", "1000", "4000", "80", "25"};
  std::vector<std::string> c{"0"};
  std::vector<std::string> gamma{"0", "45", "90"};
  std::vector<std::string> values{"10", "10", "10"};
  std::string end = "\r\n";

  [[nodiscard]] std::string str() const {
    std::string out;
    for (const auto* part : {&head, &sets, &set}) append(out, *part);
    append(out, std::vector<std::string>(10, "0.5"));
    for (const auto* part : {&c, &gamma, &values}) append(out, *part);
    return out;
  }
  /// Sets Isym, Mc and the list of planes.
  void planes(const char* isym, std::vector<std::string> angles) {
    head[2] = isym;
    head[3] = std::to_string(angles.size());
    c = std::move(angles);
  }
  [[nodiscard]] Result<PhotometricFile> parse() const { return parseLdt(str(), "lamp.ldt"); }
  [[nodiscard]] std::string error() const {
    const auto file = parse();
    return file ? "no error" : file.error().message();
  }

 private:
  void append(std::string& out, const std::vector<std::string>& lines) const {
    for (const std::string& line : lines) out += line + end;
  }
};

}  // namespace soffit::io

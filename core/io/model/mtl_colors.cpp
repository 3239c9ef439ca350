// SPDX-License-Identifier: MIT
#include "core/io/model/mtl_colors.h"

namespace soffit::io {
namespace {

constexpr std::string_view kBlank = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

}  // namespace

std::set<std::string> materialsWithColor(std::string_view mtl_text) {
  std::set<std::string> out;
  std::string current;
  while (!mtl_text.empty()) {
    const std::size_t end = mtl_text.find('\n');
    const std::string_view line = trimmed(mtl_text.substr(0, end));
    mtl_text.remove_prefix(end == std::string_view::npos ? mtl_text.size() : end + 1);
    const std::size_t gap = line.find_first_of(kBlank);
    const std::string_view key = line.substr(0, gap);
    if (gap == std::string_view::npos) continue;
    if (key == "newmtl") current = trimmed(line.substr(gap));
    if (key == "Kd") out.insert(current);
  }
  return out;
}

}  // namespace soffit::io

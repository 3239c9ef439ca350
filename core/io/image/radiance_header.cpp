// SPDX-License-Identifier: MIT
#include "core/io/image/radiance_header.h"

#include <fstream>
#include <iterator>
#include <sstream>

namespace soffit::io {
namespace {

/// Longer headers are not ours, and a broken file need not be read to its end.
constexpr int kMaxLines = 1000;

Error notRadiance(const std::filesystem::path& path) {
  return {path.string(), "expected a Radiance file that starts with \"#?\"",
          "Save it as .hdr again."};
}

}  // namespace

Result<void> addRadianceHeader(const std::filesystem::path& path, const Metadata& metadata) {
  std::ifstream in(path, std::ios::binary);
  std::string magic;
  if (!std::getline(in, magic) || !magic.starts_with("#?")) return notRadiance(path);
  const std::string rest{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  in.close();
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out << magic << '\n';
  for (const auto& [key, value] : metadata) out << key << '=' << value << '\n';
  out << rest;
  out.close();
  if (!out) return Error{path.string(), "the file cannot be written", "Is the disk full?"};
  return {};
}

Result<Metadata> readRadianceHeader(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string line;
  if (!std::getline(in, line) || !line.starts_with("#?")) return notRadiance(path);
  Metadata metadata;
  for (int i = 0; i < kMaxLines && std::getline(in, line) && !line.empty(); ++i) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos || line.starts_with("#")) continue;
    const std::string key = line.substr(0, equals);
    if (key != "FORMAT") metadata.emplace_back(key, line.substr(equals + 1));
  }
  return metadata;
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/io/photometry/photometric_file.h"

#include "core/io/photometry/ies_heading.h"
#include "core/io/photometry/ies_reader.h"
#include "core/io/photometry/ldt_reader.h"
#include "core/io/photometry/text.h"
#include "core/io/photometry/text_file.h"

#include <algorithm>

namespace soffit::io {
namespace {

bool isIes(std::string_view text, const std::string& name) {
  if (looksLikeIes(text)) return true;
  // Nothing in the text says IES: only the name can still claim it, and the reader will object.
  return upper(std::filesystem::path(name).extension().string()) == ".IES";
}

}  // namespace

std::optional<double> PhotometricFile::lightOutputRatio() const {
  if (!lamp_lumens || !(*lamp_lumens > 0.0)) return std::nullopt;
  return lumens / *lamp_lumens;
}

std::optional<std::string> PhotometricFile::keyword(std::string_view key) const {
  const auto it = std::find_if(keywords.begin(), keywords.end(),
                               [&](const Keyword& k) { return k.key == key; });
  if (it == keywords.end()) return std::nullopt;
  return it->value;
}

Result<PhotometricFile> readPhotometry(const std::filesystem::path& path) {
  const auto text = loadText(path);
  if (!text) return text.error();
  return parsePhotometry(*text, path.string(), tiltLoader(path.parent_path()));
}

Result<PhotometricFile> parsePhotometry(std::string_view text, const std::string& name,
                                        const TiltLoader& tilt) {
  return isIes(text, name) ? parseIes(text, name, tilt) : parseLdt(text, name);
}

}  // namespace soffit::io

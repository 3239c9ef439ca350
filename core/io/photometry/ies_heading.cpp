// SPDX-License-Identifier: MIT
#include "core/io/photometry/ies_heading.h"

#include "core/io/photometry/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace soffit::io {
namespace {

// More lines than any heading has; a text file without TILT= must not fill the memory.
constexpr int kMaxHeadingLines = 10000;
// A tag with all its blanks; the "line" of a file without line ends may be megabytes.
constexpr std::size_t kMaxTagLength = 80;

std::string withoutBlanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
  return text;
}

/// The value of a TILT line, however it is spaced and capitalised.
std::optional<std::string> tiltValue(std::string_view line) {
  const std::string_view l = trimmed(line);
  if (l.size() < 5 || upper(l.substr(0, 4)) != "TILT") return std::nullopt;
  const std::size_t equals = l.find_first_not_of(" \t", 4);
  if (equals == l.npos || l[equals] != '=') return std::nullopt;
  return std::string(trimmed(l.substr(equals + 1)));
}

/// The edition of a tag, 0 for one that is a tag but of no known year, nothing for other text.
std::optional<int> taggedYear(std::string_view line) {
  const std::string tag = withoutBlanks(upper(trimmed(line).substr(0, kMaxTagLength)));
  if (tag.starts_with("IESNA91")) return 1991;
  std::size_t start = std::string::npos;
  for (const std::string_view prefix : {"IESNA:LM-63-", "IES:LM-63-"}) {
    if (tag.starts_with(prefix)) start = prefix.size();
  }
  if (start == std::string::npos) return std::nullopt;
  const std::string_view year = std::string_view(tag).substr(start);
  constexpr std::array<std::pair<const char*, int>, 8> kYears{{{"1986", 1986},
                                                               {"86", 1986},
                                                               {"1991", 1991},
                                                               {"91", 1991},
                                                               {"1995", 1995},
                                                               {"95", 1995},
                                                               {"2002", 2002},
                                                               {"2019", 2019}}};
  const auto* found = std::find_if(kYears.begin(), kYears.end(),
                                   [&](const auto& y) { return year.starts_with(y.first); });
  return found != kYears.end() ? found->second : 0;
}

/// One line of keywords or free text.
void addLine(std::string_view line, int number, IesHeading& heading, int& open_blocks) {
  const std::string_view l = trimmed(line);
  if (l.empty()) return;
  const std::size_t close = l.find(']');
  if (l.front() != '[' || close == l.npos) {
    heading.keywords.push_back({"LABEL", toUtf8(l)});
    return;
  }
  const std::string key = toUtf8(upper(trimmed(l.substr(1, close - 1))));
  const std::string value = toUtf8(trimmed(l.substr(close + 1)));
  if (key == "BLOCK") ++open_blocks;
  if (key == "ENDBLOCK" && --open_blocks < 0) {
    open_blocks = 0;
    heading.warnings.push_back(fmt::format("line {}: [ENDBLOCK] without a [BLOCK]", number));
  }
  if (key != "MORE") {
    heading.keywords.push_back({key, value});
  } else if (heading.keywords.empty()) {
    heading.warnings.push_back(fmt::format("line {}: [MORE] continues no keyword", number));
  } else {
    std::string& continued = heading.keywords.back().value;
    continued += (continued.empty() || value.empty() ? "" : " ") + value;
  }
}

}  // namespace

bool looksLikeIes(std::string_view text) {
  LineCursor lines(withoutBom(text));
  if (taggedYear(lines.next())) return true;
  lines = LineCursor(withoutBom(text));
  while (!lines.atEnd() && lines.line() < kMaxHeadingLines) {
    if (tiltValue(lines.next())) return true;
  }
  return false;
}

Result<IesHeading> parseIesHeading(std::string_view text, const std::string& name) {
  IesHeading heading;
  LineCursor lines(text);
  int open_blocks = 0;
  while (!lines.atEnd() && lines.line() < kMaxHeadingLines) {
    const std::string_view line = lines.next();
    if (auto tilt = tiltValue(line)) {
      const std::string capitals = upper(*tilt);
      heading.tilt = capitals == "NONE" || capitals == "INCLUDE" ? capitals : *tilt;
      heading.data_offset = lines.offset();
      if (open_blocks > 0) heading.warnings.emplace_back("a [BLOCK] has no [ENDBLOCK]");
      return heading;
    }
    const auto year = lines.line() == 1 ? taggedYear(line) : std::nullopt;
    if (!year) {
      addLine(line, lines.line(), heading, open_blocks);
    } else if (*year != 0) {
      heading.year = *year;
    } else {
      heading.year = 2002;
      heading.warnings.push_back("unknown edition " + shown(trimmed(line)) +
                                 " is read as LM-63-2002");
    }
  }
  return Error{placeAt(name, lines.line()),
               "expected a line TILT=NONE, TILT=INCLUDE or TILT= with a file, found none",
               "The file is cut off or no IES file. Download it again from the manufacturer."};
}

}  // namespace soffit::io

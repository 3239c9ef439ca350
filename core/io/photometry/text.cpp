// SPDX-License-Identifier: MIT
#include "core/io/photometry/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace soffit::io {
namespace {

bool isControl(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

bool isBlank(char c) {
  return c == ' ' || isControl(c);
}

/// Length of the UTF-8 sequence at the start, 0 if there is none. Overlong forms and surrogates
/// are refused, as JSON writers refuse them.
std::size_t utf8Length(std::string_view s) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t n = lead >= 0xc2 && lead <= 0xdf   ? 2
                        : lead >= 0xe0 && lead <= 0xef ? 3
                        : lead >= 0xf0 && lead <= 0xf4 ? 4
                                                       : 0;
  if (n == 0 || s.size() < n) return 0;
  for (std::size_t i = 1; i < n; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  const unsigned char second = byte(1);
  const bool wrong = (lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) ||
                     (lead == 0xf0 && second < 0x90) || (lead == 0xf4 && second > 0x8f);
  return wrong ? 0 : n;
}

bool isUtf8(std::string_view s) {
  while (!s.empty()) {
    const std::size_t n = utf8Length(s);
    if (n == 0) return false;
    s.remove_prefix(n);
  }
  return true;
}

}  // namespace

std::string_view withoutBom(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return text;
}

Result<void> checkReadable(std::string_view text, const std::string& name, std::string_view kind) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    return Error{placeAt(name, 1), fmt::format("expected {} in ASCII or UTF-8, found UTF-16", kind),
                 "Save it again as plain text (ASCII or UTF-8)."};
  }
  if (trimmed(withoutBom(text)).empty()) {
    return Error{placeAt(name, 1), fmt::format("expected {}, found an empty file", kind),
                 "Download it again from the manufacturer."};
  }
  return {};
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return out;
}

std::string toUtf8(std::string_view text) {
  const bool utf8 = isUtf8(text);
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (isControl(c)) {
      out += ' ';
    } else if (utf8 || byte < 0x80) {
      out += c;
    } else {
      out += static_cast<char>(0xc0 | (byte >> 6));
      out += static_cast<char>(0x80 | (byte & 0x3f));
    }
  }
  return out;
}

std::string shown(std::string_view token) {
  constexpr std::size_t kLongest = 24;
  std::string out = "'";
  for (const char c : token.substr(0, kLongest)) out += c >= 0x20 && c < 0x7f ? c : '?';
  return out + (token.size() > kLongest ? "...'" : "'");
}

std::optional<double> parseNumber(std::string_view token) {
  if (token.starts_with('+')) {
    token.remove_prefix(1);
    if (token.starts_with('-')) return std::nullopt;
  }
  double value = 0.0;
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    const bool tiny = token.find("e-") != token.npos || token.find("E-") != token.npos;
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return value;
}

int lineAt(std::string_view text, std::size_t offset) {
  LineCursor lines(text);
  do {
    lines.next();
  } while (!lines.atEnd() && lines.offset() <= offset);
  return lines.line();
}

std::string placeAt(const std::string& name, int line) {
  return fmt::format("{}:{}", name, line);
}

std::string_view LineCursor::next() {
  const std::size_t start = std::min(offset_, text_.size());
  // A plain loop: find_first_of() calls memchr for every character, 25 ns each.
  std::size_t stop = start;
  while (stop < text_.size() && text_[stop] != '\n' && text_[stop] != '\r') ++stop;
  const std::string_view rest = text_.substr(stop);
  offset_ = stop;
  if (rest.starts_with("\r\r\n")) {
    offset_ += 3;
  } else if (rest.starts_with("\r\n")) {
    offset_ += 2;
  } else if (!rest.empty()) {
    offset_ += 1;
  }
  ++line_;
  return text_.substr(start, stop - start);
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/io/photometry/number_stream.h"

#include "core/io/photometry/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::io {
namespace {

constexpr const char* kEndsEarly = "The file ends too early. Download it again.";
constexpr const char* kNotNumber = "The file is damaged or no photometric file. Download it again.";

// Degrees. Angles closer than this are one angle with noise; no goniometer resolves them.
constexpr double kSameAngle = 1e-6;

bool separates(char c, Comma comma) {
  return static_cast<unsigned char>(c) <= ' ' || (c == ',' && comma == Comma::separator);
}

std::optional<double> parse(std::string_view token, Comma comma) {
  const std::size_t at = token.find(',');
  if (comma == Comma::separator || at == token.npos) return parseNumber(token);
  std::string dotted(token);
  dotted[at] = '.';
  return parseNumber(dotted);  // a second comma or dot is no number
}

}  // namespace

NumberStream::NumberStream(std::string_view text, std::size_t offset, std::string name, Comma comma)
    : text_(text),
      offset_(std::min(offset, text.size())),
      token_offset_(offset_),
      name_(std::move(name)),
      comma_(comma) {}

std::string_view NumberStream::token() {
  std::size_t start = offset_;
  while (start < text_.size() && separates(text_[start], comma_)) ++start;
  if (start == text_.size()) {
    offset_ = start;
    return {};  // token_offset_ stays at the last token: that is the line to look at
  }
  std::size_t stop = start;
  while (stop < text_.size() && !separates(text_[stop], comma_)) ++stop;
  offset_ = stop;
  token_offset_ = start;
  return text_.substr(start, stop - start);
}

Error NumberStream::error(std::string what, std::string hint) const {
  return {placeAt(name_, lineAt(text_, token_offset_)), std::move(what), std::move(hint)};
}

Result<double> NumberStream::number(std::string_view what) {
  const std::string_view found = token();
  if (found.empty()) {
    return error(fmt::format("expected {}, found the end of the file", what), kEndsEarly);
  }
  const auto value = parse(found, comma_);
  if (!value || !std::isfinite(*value)) {
    return error(fmt::format("expected {}, found {}", what, shown(found)), kNotNumber);
  }
  return *value;
}

Result<int> NumberStream::whole(std::string_view what, int min, int max) {
  const auto value = number(what);
  if (!value) return value.error();
  if (*value != std::floor(*value) || *value < min || *value > max) {
    return error(fmt::format("expected {} ({} to {}), found {:g}", what, min, max, *value),
                 kNotNumber);
  }
  return static_cast<int>(*value);
}

Result<std::vector<double>> NumberStream::numbers(std::size_t count, std::string_view what) {
  return read(count, what, false);
}

Result<std::vector<double>> NumberStream::ascending(std::size_t count, std::string_view what) {
  return read(count, what, true);
}

Result<std::vector<double>> NumberStream::read(std::size_t count, std::string_view what,
                                               bool ascending) {
  std::vector<double> values;
  values.reserve(std::min(count, charactersLeft() / 2 + 1));  // a digit and a separator each
  while (values.size() < count) {
    const std::string_view found = token();
    if (found.empty()) {
      return error(fmt::format("expected {} {}, found {}", count, what, values.size()), kEndsEarly);
    }
    const auto value = parse(found, comma_);
    if (!value || !std::isfinite(*value)) {
      return error(fmt::format("expected {} {}, found {} after {} of them", count, what,
                               shown(found), values.size()),
                   kNotNumber);
    }
    if (ascending && !values.empty() && !(*value > values.back() + kSameAngle)) {
      return error(
          fmt::format("expected ascending {}, found {:g} after {:g}", what, *value, values.back()),
          "The angles are damaged, or a number before them is missing or too much.");
    }
    values.push_back(*value);
  }
  return values;
}

std::size_t NumberStream::remaining() {
  std::size_t count = 0;
  while (parse(token(), comma_)) ++count;
  return count;
}

}  // namespace soffit::io

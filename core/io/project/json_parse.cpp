// SPDX-License-Identifier: MIT
#include "core/io/project/json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <exception>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace soffit::io {
namespace {

constexpr std::size_t kDeepest = 64;

struct Position {
  std::size_t line = 1;
  std::size_t column = 1;
};

/// Line and column of the byte before which `count` bytes lie; columns count bytes.
Position positionAfter(std::string_view text, std::size_t count) {
  Position position;
  for (const char c : text.substr(0, std::min(count, text.size()))) {
    ++position.column;
    if (c == '\n') position = {position.line + 1, 1};
  }
  return position;
}

/// What nlohmann says after its own address and position.
std::string reason(std::string message) {
  const auto colon = message.find(": ");
  if (colon != std::string::npos) message.erase(0, colon + 2);
  constexpr std::string_view kPrefix = "syntax error while parsing ";
  if (message.starts_with(kPrefix)) message = "in " + message.substr(kPrefix.size());
  return message;
}

/// Builds the tree while nlohmann reads; stops at the first fault.
class TreeBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  bool null() override { return put(Json()); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(number_integer_t value) override {
    return put(JsonNumber{static_cast<double>(value), fmt::format("{}", value)});
  }
  bool number_unsigned(number_unsigned_t value) override {
    return put(JsonNumber{static_cast<double>(value), fmt::format("{}", value)});
  }
  bool number_float(number_float_t value, const string_t& spelling) override {
    return put(JsonNumber{value, spelling});
  }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }

  bool start_object(std::size_t /*size*/) override { return open(JsonObject()); }
  bool start_array(std::size_t /*size*/) override { return open(JsonArray()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& value) override {
    Level& level = levels_.back();
    if (!level.keys.insert(value).second) {
      fault_ =
          Error{std::string(file_), fmt::format("the key \"{}\" occurs twice in one object", value),
                "Keep one of the two."};
      return false;
    }
    level.key = std::move(value);
    return true;
  }

  bool parse_error(std::size_t byte, const std::string& /*token*/,
                   const nlohmann::json::exception& fault) override {
    // `byte` counts from 1 and includes the offending one.
    const Position at = positionAfter(text_, byte == 0 ? 0 : byte - 1);
    fault_ = Error{fmt::format("{}:{}:{}", file_, at.line, at.column),
                   fmt::format("this is not JSON: {}", reason(fault.what())),
                   "Correct the file there, or just before."};
    return false;
  }

  Result<Json> take() {
    if (fault_) return *fault_;
    return std::move(root_);
  }
  void fail(Error fault) { fault_ = std::move(fault); }

 private:
  struct Level {
    Json value;
    std::string key;
    std::set<std::string> keys;
  };

  bool open(Json container) {
    if (levels_.size() >= kDeepest) {
      fault_ = Error{std::string(file_), fmt::format("more than {} levels of brackets", kDeepest),
                     "This is not a project file; give one."};
      return false;
    }
    levels_.push_back({std::move(container), {}, {}});
    return true;
  }

  bool close() {
    Json done = std::move(levels_.back().value);
    levels_.pop_back();
    return put(std::move(done));
  }

  bool put(Json value) {
    if (levels_.empty()) {
      root_ = std::move(value);
    } else if (JsonArray* array = levels_.back().value.asArray()) {
      array->push_back(std::move(value));
    } else {
      levels_.back().value.asObject()->push_back({std::move(levels_.back().key), std::move(value)});
    }
    return true;
  }

  std::string_view text_;
  std::string_view file_;
  std::vector<Level> levels_;
  Json root_;
  std::optional<Error> fault_;
};

}  // namespace

Result<Json> parseJson(std::string_view text, std::string_view file) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  TreeBuilder builder(text, file);
  try {
    nlohmann::json::sax_parse(text.begin(), text.end(), &builder,
                              nlohmann::json::input_format_t::json, /*strict=*/true,
                              /*ignore_comments=*/true);
  } catch (const std::exception& fault) {
    builder.fail({std::string(file), reason(fault.what()), "Correct the file."});
  }
  return builder.take();
}

}  // namespace soffit::io

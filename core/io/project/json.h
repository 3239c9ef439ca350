// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// JSON as a value that gives back what it read: members keep their order and numbers their
/// spelling. The parser behind it is nlohmann's; no type of it shows here.
namespace soffit::io {

class Json;
struct JsonMember;
using JsonArray = std::vector<Json>;
using JsonObject = std::vector<JsonMember>;

/// A number and, when it came from a file, how it was spelled there.
struct JsonNumber {
  double value = 0.0;
  std::string spelling;
};

/// null, bool, number, text, array or object. Value semantics.
class Json {
 public:
  Json();
  Json(bool value);             // NOLINT: implicit on purpose, as are the others
  Json(const char* text);       // NOLINT
  Json(std::string text);       // NOLINT
  Json(std::string_view text);  // NOLINT
  Json(JsonNumber number);      // NOLINT
  Json(JsonArray array);        // NOLINT
  Json(JsonObject object);      // NOLINT
  template <class T>
  requires(std::integral<T> || std::floating_point<T>) && (!std::same_as<T, bool>)Json(T value)
      : Json(JsonNumber{static_cast<double>(value), {}}) {}  // NOLINT
  Json(const Json&);
  Json(Json&&) noexcept;
  Json& operator=(const Json&);
  Json& operator=(Json&&) noexcept;
  ~Json();

  static Json object(std::initializer_list<std::pair<std::string_view, Json>> members = {});
  static Json array(std::initializer_list<Json> elements = {});

  [[nodiscard]] bool isNull() const;
  [[nodiscard]] const bool* asBool() const;  ///< null when it is something else
  [[nodiscard]] const JsonNumber* asNumber() const;
  [[nodiscard]] const std::string* asText() const;
  [[nodiscard]] const JsonArray* asArray() const;
  [[nodiscard]] const JsonObject* asObject() const;
  [[nodiscard]] JsonArray* asArray();
  [[nodiscard]] JsonObject* asObject();

  /// The member of an object; null when absent or when this is no object.
  [[nodiscard]] const Json* find(std::string_view key) const;
  [[nodiscard]] Json* find(std::string_view key);
  /// The member, added at the end when absent. This becomes an object if it is none.
  Json& operator[](std::string_view key);
  /// Removes a member; nothing happens when it is absent.
  void erase(std::string_view key);

  /// Equal in content: numbers by value, objects regardless of the order of members.
  [[nodiscard]] bool operator==(const Json& other) const;

  /// A short description for messages: `"abc"`, `3`, `an array`, `null`.
  [[nodiscard]] std::string describe() const;

 private:
  std::variant<std::nullptr_t, bool, JsonNumber, std::string, JsonArray, JsonObject> value_;
};

struct JsonMember {
  std::string key;
  Json value;
};

/// Reads JSON text, comments allowed, a byte order mark skipped.
///
/// file  names the text in errors.
/// Errors: syntax ("office.soffit:12:3"), a key that occurs twice in one object, numbers out of
/// range, text that is not UTF-8, more than 64 levels.
Result<Json> parseJson(std::string_view text, std::string_view file);

/// Writes JSON, indented by two, ending in a newline. Arrays of scalars and small objects stay on
/// one line. Numbers keep their spelling or take the shortest that reads back the same; what is
/// not finite is written as null (JSON has no word for it).
std::string formatJson(const Json& value);

/// The same without any line break, for `--json`.
std::string formatJsonLine(const Json& value);

}  // namespace soffit::io

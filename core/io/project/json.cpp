// SPDX-License-Identifier: MIT
#include "core/io/project/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace soffit::io {

Json::Json() : value_(nullptr) {}
Json::Json(bool value) : value_(value) {}
Json::Json(const char* text) : value_(std::string(text)) {}
Json::Json(std::string text) : value_(std::move(text)) {}
Json::Json(std::string_view text) : value_(std::string(text)) {}
Json::Json(JsonNumber number) : value_(std::move(number)) {}
Json::Json(JsonArray array) : value_(std::move(array)) {}
Json::Json(JsonObject object) : value_(std::move(object)) {}
Json::Json(const Json&) = default;
Json::Json(Json&&) noexcept = default;
Json& Json::operator=(const Json&) = default;
Json& Json::operator=(Json&&) noexcept = default;
Json::~Json() = default;

Json Json::object(std::initializer_list<std::pair<std::string_view, Json>> members) {
  JsonObject object;
  for (const auto& [key, value] : members) object.push_back({std::string(key), value});
  return object;
}

Json Json::array(std::initializer_list<Json> elements) {
  return JsonArray(elements);
}

bool Json::isNull() const {
  return std::holds_alternative<std::nullptr_t>(value_);
}
const bool* Json::asBool() const {
  return std::get_if<bool>(&value_);
}
const JsonNumber* Json::asNumber() const {
  return std::get_if<JsonNumber>(&value_);
}
const std::string* Json::asText() const {
  return std::get_if<std::string>(&value_);
}
const JsonArray* Json::asArray() const {
  return std::get_if<JsonArray>(&value_);
}
const JsonObject* Json::asObject() const {
  return std::get_if<JsonObject>(&value_);
}
JsonArray* Json::asArray() {
  return std::get_if<JsonArray>(&value_);
}
JsonObject* Json::asObject() {
  return std::get_if<JsonObject>(&value_);
}

const Json* Json::find(std::string_view key) const {
  const JsonObject* object = asObject();
  if (object == nullptr) return nullptr;
  const auto found = std::ranges::find(*object, key, &JsonMember::key);
  return found == object->end() ? nullptr : &found->value;
}

Json* Json::find(std::string_view key) {
  return const_cast<Json*>(std::as_const(*this).find(key));  // NOLINT: this is not const here
}

Json& Json::operator[](std::string_view key) {
  if (Json* found = find(key)) return *found;
  if (asObject() == nullptr) value_ = JsonObject();
  JsonObject& object = *asObject();
  object.push_back({std::string(key), Json()});
  return object.back().value;
}

void Json::erase(std::string_view key) {
  if (JsonObject* object = asObject()) {
    std::erase_if(*object, [&](const JsonMember& member) { return member.key == key; });
  }
}

bool Json::operator==(const Json& other) const {
  if (value_.index() != other.value_.index()) return false;
  if (const bool* flag = asBool()) return *flag == *other.asBool();
  if (const JsonNumber* number = asNumber()) return number->value == other.asNumber()->value;
  if (const std::string* text = asText()) return *text == *other.asText();
  if (const JsonArray* array = asArray()) return *array == *other.asArray();
  if (const JsonObject* object = asObject()) {
    if (object->size() != other.asObject()->size()) return false;
    return std::ranges::all_of(*object, [&](const JsonMember& member) {
      const Json* match = other.find(member.key);
      return match != nullptr && member.value == *match;
    });
  }
  return true;  // null
}

std::string Json::describe() const {
  if (isNull()) return "null";
  if (const bool* flag = asBool()) return *flag ? "true" : "false";
  if (const JsonNumber* number = asNumber()) {
    return number->spelling.empty() ? fmt::format("{}", number->value) : number->spelling;
  }
  if (const JsonArray* array = asArray()) {
    return array->size() == 1 ? "an array of 1 element"
                              : fmt::format("an array of {} elements", array->size());
  }
  if (asObject() != nullptr) return "an object";
  constexpr std::size_t kLongest = 40;
  const std::string& text = *asText();
  if (text.size() <= kLongest) return fmt::format("\"{}\"", text);
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return fmt::format("\"{}...\"", text.substr(0, end));
}

}  // namespace soffit::io

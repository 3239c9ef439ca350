// SPDX-License-Identifier: MIT
#include "core/io/project/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::io {

void Report::fail(std::string_view path, std::string what, std::string hint) {
  if (error_) return;
  std::string place = path.empty() ? file_ : fmt::format("{}: {}", file_, path);
  error_ = Error{std::move(place), std::move(what), std::move(hint)};
}

void Report::failAt(std::string_view path, const Error& fault) {
  fail(path, fault.place.empty() ? fault.what : fmt::format("{}: {}", fault.place, fault.what),
       fault.hint);
}

void Report::warn(std::string_view path, std::string_view what) {
  warnings_.push_back(path.empty() ? std::string(what) : fmt::format("{}: {}", path, what));
}

void Report::unknownKey(std::string_view path) {
  const bool from_set = std::ranges::any_of(set_paths_, [&](const std::string& set) {
    return set.starts_with(path) && (set.size() == path.size() || set[path.size()] == '.');
  });
  if (from_set) {
    fail(path, "--set names a field that does not exist", "Check the spelling of the path.");
  } else {
    warn(path, "this key is not known; it is kept and has no effect");
  }
}

bool Report::isSet(std::string_view path) const {
  return set_paths_.contains(path);
}

ObjectReader::ObjectReader(const Json& value, std::string path, Report& report)
    : value_(value), path_(std::move(path)), report_(report) {
  if (value.asObject() == nullptr) {
    report.fail(path_, fmt::format("expected an object, found {}", value.describe()),
                "Write it as { \"key\": value, ... }.");
  }
}

ObjectReader::~ObjectReader() {
  const JsonObject* object = value_.asObject();
  if (object == nullptr) return;
  for (const JsonMember& member : *object) {
    if (!known_.contains(member.key)) report_.unknownKey(pathOf(member.key));
  }
}

const Json* ObjectReader::get(std::string_view key) {
  known_.emplace(key);
  return value_.find(key);
}

std::string ObjectReader::pathOf(std::string_view key) const {
  return joinPath(path_, key);
}

void ObjectReader::read(std::string_view key, double& target) {
  const Json* value = get(key);
  if (value == nullptr) return;
  if (const auto number = readNumber(*value, pathOf(key), report_)) target = *number;
}

void ObjectReader::read(std::string_view key, int& target) {
  const Json* value = get(key);
  if (value == nullptr) return;
  const JsonNumber* number = value->asNumber();
  constexpr double kLargest = 1e9;
  if (number == nullptr || std::trunc(number->value) != number->value ||
      std::abs(number->value) > kLargest) {
    report_.fail(pathOf(key), fmt::format("expected a whole number, found {}", value->describe()),
                 "Write it without quotes and decimals.");
    return;
  }
  target = static_cast<int>(number->value);
}

void ObjectReader::read(std::string_view key, bool& target) {
  const Json* value = get(key);
  if (value == nullptr) return;
  if (const bool* flag = value->asBool()) {
    target = *flag;
  } else {
    report_.fail(pathOf(key), fmt::format("expected true or false, found {}", value->describe()),
                 "Write it without quotes.");
  }
}

void ObjectReader::read(std::string_view key, std::string& target) {
  const Json* value = get(key);
  if (value == nullptr) return;
  if (const std::string* text = value->asText()) {
    target = *text;
  } else if (value->asNumber() != nullptr && report_.isSet(pathOf(key))) {
    target = value->asNumber()->spelling;  // --set group=5 means the text "5"
  } else {
    report_.fail(pathOf(key), fmt::format("expected text, found {}", value->describe()),
                 "Write it in double quotes.");
  }
}

void ObjectReader::read(std::string_view key, dvec3& target) {
  const Json* value = get(key);
  if (value == nullptr) return;
  if (const auto numbers = readNumbers(*value, 3, pathOf(key), report_)) {
    target = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  }
}

void ObjectReader::read(std::string_view key, dvec2& target) {
  const Json* value = get(key);
  if (value == nullptr) return;
  if (const auto numbers = readNumbers(*value, 2, pathOf(key), report_)) {
    target = {(*numbers)[0], (*numbers)[1]};
  }
}

void ObjectReader::require(std::string_view key, std::string_view example) {
  if (value_.asObject() == nullptr || get(key) != nullptr) return;
  report_.fail(pathOf(key), "this key is missing", fmt::format("Add \"{}\": {}.", key, example));
}

std::optional<double> readNumber(const Json& value, std::string_view path, Report& report) {
  const JsonNumber* number = value.asNumber();
  if (number != nullptr && std::isfinite(number->value)) return number->value;
  report.fail(path, fmt::format("expected a finite number, found {}", value.describe()),
              "Write it without quotes, with a decimal point.");
  return std::nullopt;
}

std::optional<std::vector<double>> readNumbers(const Json& value, std::size_t count,
                                               std::string_view path, Report& report) {
  const JsonArray* array = value.asArray();
  if (array == nullptr || array->size() != count) {
    report.fail(path, fmt::format("expected {} numbers, found {}", count, value.describe()),
                count == 2 ? "Write them as [a, b]." : "Write them as [a, b, c].");
    return std::nullopt;
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = readNumber((*array)[i], fmt::format("{}[{}]", path, i), report);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::string joinPath(std::string_view parent, std::string_view key) {
  return parent.empty() ? std::string(key) : fmt::format("{}.{}", parent, key);
}

std::string elementPath(std::string_view list, std::size_t index, const Json& element) {
  const Json* name = element.find("name");
  const std::string* text = name == nullptr ? nullptr : name->asText();
  if (text == nullptr || text->empty()) return fmt::format("{}[{}]", list, index);
  return fmt::format("{}.{}", list, *text);
}

}  // namespace soffit::io

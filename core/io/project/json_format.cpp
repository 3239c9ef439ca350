// SPDX-License-Identifier: MIT
#include "core/io/project/json.h"
#include "core/io/project/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace soffit::io {
namespace {

constexpr std::size_t kLineWidth = 100;

void writeCharacter(char c, std::string& out) {
  const auto byte = static_cast<unsigned char>(c);
  if (c == '"' || c == '\\') {
    out += '\\';
    out += c;
  } else if (c == '\n') {
    out += "\\n";
  } else if (c == '\t') {
    out += "\\t";
  } else if (c == '\r') {
    out += "\\r";
  } else if (byte < 0x20 || byte == 0x7F) {
    out += fmt::format("\\u{:04x}", static_cast<unsigned>(byte));
  } else {
    out += c;
  }
}

/// Bytes that are not UTF-8 become U+FFFD: the text must stay readable as JSON.
void writeText(std::string_view text, std::string& out) {
  out += '"';
  while (!text.empty()) {
    const std::size_t length = utf8SequenceLength(text);
    if (length == 0) out += "\\ufffd";
    if (length == 1) writeCharacter(text.front(), out);
    if (length > 1) out += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  out += '"';
}

void writeNumber(const JsonNumber& number, std::string& out) {
  if (!number.spelling.empty()) {
    out += number.spelling;
  } else if (!std::isfinite(number.value)) {
    out += "null";
  } else if (number.value == 0.0 && std::signbit(number.value)) {
    out += "-0.0";  // "-0" is read as the integer 0
  } else {
    char digits[40];
    const auto end = std::to_chars(std::begin(digits), std::end(digits), number.value);
    out.append(std::begin(digits), end.ptr);
  }
}

bool isScalar(const Json& value) {
  return value.asArray() == nullptr && value.asObject() == nullptr;
}

/// On one line: `{ "a": 1, "b": [1, 2] }`.
void writeLine(const Json& value, std::string& out) {
  if (value.isNull()) out += "null";
  if (const bool* flag = value.asBool()) out += *flag ? "true" : "false";
  if (const JsonNumber* number = value.asNumber()) writeNumber(*number, out);
  if (const std::string* text = value.asText()) writeText(*text, out);
  if (const JsonArray* array = value.asArray()) {
    out += '[';
    for (std::size_t i = 0; i < array->size(); ++i) {
      if (i > 0) out += ", ";
      writeLine((*array)[i], out);
    }
    out += ']';
  }
  if (const JsonObject* object = value.asObject()) {
    out += object->empty() ? "{" : "{ ";
    for (std::size_t i = 0; i < object->size(); ++i) {
      if (i > 0) out += ", ";
      writeText((*object)[i].key, out);
      out += ": ";
      writeLine((*object)[i].value, out);
    }
    out += object->empty() ? "}" : " }";
  }
}

/// Whether a container reads well on one line: nothing in it is deeper than two levels.
bool isFlat(const Json& value, int levels) {
  if (isScalar(value)) return true;
  if (levels == 0) return false;
  if (const JsonArray* array = value.asArray()) {
    return std::ranges::all_of(*array, [&](const Json& e) { return isFlat(e, levels - 1); });
  }
  return std::ranges::all_of(*value.asObject(),
                             [&](const JsonMember& m) { return isFlat(m.value, levels - 1); });
}

void writeTree(const Json& value, std::size_t indent, std::string& out);

template <class Container, class WriteElement>
void writeLines(const Container& elements, char open, char close, std::size_t indent,
                std::string& out, const WriteElement& write_element) {
  out += open;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    out += i > 0 ? ",\n" : "\n";
    out.append(indent + 2, ' ');
    write_element(elements[i]);
  }
  out += '\n';
  out.append(indent, ' ');
  out += close;
}

void writeTree(const Json& value, std::size_t indent, std::string& out) {
  if (indent > 0 && isFlat(value, 2)) {
    std::string line;
    writeLine(value, line);
    const auto* array = value.asArray();
    const bool numbers = array != nullptr && std::ranges::all_of(*array, isScalar);
    if (numbers || isScalar(value) || indent + line.size() <= kLineWidth) {
      out += line;
      return;
    }
  }
  if (const JsonArray* array = value.asArray(); array != nullptr && !array->empty()) {
    writeLines(*array, '[', ']', indent, out,
               [&](const Json& element) { writeTree(element, indent + 2, out); });
  } else if (const JsonObject* object = value.asObject(); object != nullptr && !object->empty()) {
    writeLines(*object, '{', '}', indent, out, [&](const JsonMember& member) {
      writeText(member.key, out);
      out += ": ";
      writeTree(member.value, indent + 2, out);
    });
  } else {
    writeLine(value, out);
  }
}

}  // namespace

std::string formatJson(const Json& value) {
  std::string out;
  writeTree(value, 0, out);
  out += '\n';
  return out;
}

std::string formatJsonLine(const Json& value) {
  std::string out;
  writeLine(value, out);
  return out;
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/io/project/csv.h"

#include "core/io/project/atomic_file.h"
#include "core/scene/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace soffit::io {
namespace {

constexpr std::string_view kSensorHeader = "x,y,z,nx,ny,nz";
constexpr std::string_view kPathHeader = "x,y,z";

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = trimmed(text.substr(1, text.size() - 2));
  }
  return text;
}

/// Takes the text up to the next line end (LF, CRLF or CR) off `text`.
std::string_view nextLine(std::string_view& text) {
  const auto end = text.find_first_of("\r\n");
  const std::string_view line = text.substr(0, end);
  if (end == std::string_view::npos) {
    text = {};
  } else {
    const bool pair = text.substr(end, 2) == "\r\n";
    text.remove_prefix(end + (pair ? 2 : 1));
  }
  return line;
}

std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const auto comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

bool matchesHeader(std::string_view line, std::string_view header) {
  std::string names;
  for (const std::string_view field : fieldsOf(line)) {
    if (!names.empty()) names += ',';
    for (const char c : field) {
      names += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return names == header;
}

std::optional<double> finiteNumber(std::string_view field) {
  if (field.starts_with('+')) field.remove_prefix(1);
  double value = 0.0;
  const auto [end, code] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (code != std::errc() || end != field.data() + field.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

template <std::size_t N>
struct Row {
  std::size_t line = 0;
  std::array<double, N> numbers{};
};

template <std::size_t N>
Result<Row<N>> parseRow(std::string_view line, std::string place) {
  const auto fields = fieldsOf(line);
  if (fields.size() != N) {
    return Error{std::move(place),
                 fmt::format("expected {} numbers, found {} fields", N, fields.size()),
                 "Separate the numbers by commas, with decimal points."};
  }
  Row<N> row;
  for (std::size_t k = 0; k < N; ++k) {
    const auto number = finiteNumber(fields[k]);
    if (!number) {
      return Error{std::move(place),
                   fmt::format("expected a finite number, found \"{}\"", fields[k].substr(0, 40)),
                   "Write it with a decimal point, in metres."};
    }
    if (k < 3 && std::abs(*number) > scene::kFarthest) {
      return Error{std::move(place),
                   fmt::format("expected numbers up to {:g}, found \"{}\"", scene::kFarthest,
                               fields[k].substr(0, 40)),
                   "Write coordinates in metres."};
    }
    row.numbers[k] = *number;
  }
  return row;
}

template <std::size_t N>
Result<std::vector<Row<N>>> parseRows(std::string_view text, std::string_view name,
                                      std::string_view header) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<Row<N>> rows;
  bool header_seen = false;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = nextLine(text);
    if (trimmed(line).empty()) continue;
    std::string place = fmt::format("{}:{}", name, number);
    if (!header_seen) {
      if (!matchesHeader(line, header)) {
        return Error{std::move(place), fmt::format("expected the header \"{}\"", header),
                     "Put it in the first line."};
      }
      header_seen = true;
      continue;
    }
    auto row = parseRow<N>(line, std::move(place));
    if (!row) return row.error();
    row->line = number;
    rows.push_back(*row);
  }
  if (rows.empty()) {
    return Error{std::string(name), "there are no points in the file",
                 fmt::format("It needs the header \"{}\" and a row for each point.", header)};
  }
  return rows;
}

}  // namespace

Result<std::vector<scene::Sensor>> parseSensors(std::string_view text, std::string_view name) {
  const auto rows = parseRows<6>(text, name, kSensorHeader);
  if (!rows) return rows.error();
  std::vector<scene::Sensor> sensors;
  sensors.reserve(rows->size());
  for (const auto& row : *rows) {
    const auto& n = row.numbers;
    // Scaled first, so that tiny and huge normals neither vanish nor overflow when squared.
    const double largest = std::max({std::abs(n[3]), std::abs(n[4]), std::abs(n[5])});
    if (largest == 0.0) {
      return Error{fmt::format("{}:{}", name, row.line), "the normal nx,ny,nz has no length",
                   "Give the direction that the sensor faces, 0,0,1 for upward."};
    }
    const dvec3 direction(n[3] / largest, n[4] / largest, n[5] / largest);
    sensors.push_back({{n[0], n[1], n[2]}, glm::normalize(direction)});
  }
  return sensors;
}

Result<std::vector<dvec3>> parsePath(std::string_view text, std::string_view name) {
  const auto rows = parseRows<3>(text, name, kPathHeader);
  if (!rows) return rows.error();
  std::vector<dvec3> points;
  points.reserve(rows->size());
  for (const auto& row : *rows) points.emplace_back(row.numbers[0], row.numbers[1], row.numbers[2]);
  return points;
}

Result<std::vector<scene::Sensor>> readSensors(const std::filesystem::path& path) {
  const auto text = readFile(path);
  if (!text) return text.error();
  return parseSensors(*text, path.string());
}

Result<std::vector<dvec3>> readPath(const std::filesystem::path& path) {
  const auto text = readFile(path);
  if (!text) return text.error();
  return parsePath(*text, path.string());
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/design/bench_row.h"

#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <span>

namespace soffit::design {
namespace {

/// A column: how it is written and read, by one way to its place, so that they cannot drift apart.
struct Column {
  const char* name;
  std::function<std::string(BenchRow&)> write;
  std::function<bool(BenchRow&, std::string_view)> read;
};

template <class T>
bool readNumber(std::string_view text, T& value) {
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  return parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
}

template <class Access>
Column text(const char* name, Access access) {
  return {name, [access](BenchRow& row) { return access(row); },
          [access](BenchRow& row, std::string_view field) {
            access(row) = std::string(field);
            return true;
          }};
}

template <class Access>
Column number(const char* name, Access access) {
  return {
      name, [access](BenchRow& row) { return fmt::format("{}", access(row)); },
      [access](BenchRow& row, std::string_view field) { return readNumber(field, access(row)); }};
}

#define SOFFIT_FIELD(member) ([](BenchRow & row) -> auto& { return (row.member); })

const std::vector<Column>& columns() {
  static const std::vector<Column> list{
      text("project", SOFFIT_FIELD(project)),
      text("method", SOFFIT_FIELD(method)),
      text("settings", SOFFIT_FIELD(settings)),
      number("receivers", SOFFIT_FIELD(receivers)),
      number("update_ms", SOFFIT_FIELD(update_ms)),
      number("update_p99_ms", SOFFIT_FIELD(update_p99_ms)),
      number("direct_ms", SOFFIT_FIELD(stages.direct)),
      number("first_bounce_ms", SOFFIT_FIELD(stages.first_bounce)),
      number("nodes_ms", SOFFIT_FIELD(stages.nodes)),
      number("gather_ms", SOFFIT_FIELD(stages.gather)),
      number("sweep_ms", SOFFIT_FIELD(stages.sweep)),
      number("interpolate_ms", SOFFIT_FIELD(stages.interpolate)),
      number("mix_ms", SOFFIT_FIELD(mix_ms)),
      number("paint_ms", SOFFIT_FIELD(paint_ms)),
      number("rms", SOFFIT_FIELD(total.rms)),
      number("p95", SOFFIT_FIELD(total.p95)),
      number("bias", SOFFIT_FIELD(total.bias)),
      number("rms_stderr", SOFFIT_FIELD(total.rms_stderr)),
      number("reference_stderr", SOFFIT_FIELD(total.reference_stderr)),
      number("alone_rms", SOFFIT_FIELD(alone.rms)),
      number("alone_p95", SOFFIT_FIELD(alone.p95)),
      number("alone_bias", SOFFIT_FIELD(alone.bias)),
      number("alone_rms_stderr", SOFFIT_FIELD(alone.rms_stderr)),
      number("alone_reference_stderr", SOFFIT_FIELD(alone.reference_stderr)),
      number("test_points", SOFFIT_FIELD(total.receivers)),
      number("mean_lux", SOFFIT_FIELD(total.mean_lux)),
      number("alone_mean_lux", SOFFIT_FIELD(alone.mean_lux)),
      number("rays", SOFFIT_FIELD(rays)),
      number("rays_avoided", SOFFIT_FIELD(rays_avoided)),
      number("bake_s", SOFFIT_FIELD(bake_s)),
      number("first_result_s", SOFFIT_FIELD(first_result_s)),
      number("bake_rays", SOFFIT_FIELD(bake_rays)),
      number("operator_bytes", SOFFIT_FIELD(operator_bytes)),
      number("peak_bytes", SOFFIT_FIELD(peak_bytes)),
      text("light", SOFFIT_FIELD(light)),
      text("version", SOFFIT_FIELD(version)),
      text("scene", SOFFIT_FIELD(scene)),
  };
  return list;
}

#undef SOFFIT_FIELD

/// Texts are names of ours or of a file and a luminaire: what would need quoting is replaced.
std::string plain(std::string text) {
  for (char& c : text) {
    if (c == ',' || c == '"' || c == '\n' || c == '\r') c = ';';
  }
  return text;
}

std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t comma = line.find(',');
    fields.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

Result<BenchRow> rowOf(std::span<const std::string_view> header, std::string_view line,
                       const std::string& place) {
  const std::vector<std::string_view> fields = fieldsOf(line);
  if (fields.size() != header.size()) {
    return Error{place, fmt::format("expected {} fields, found {}", header.size(), fields.size()),
                 "Remove the file to measure everything again."};
  }
  BenchRow row;
  for (const Column& column : columns()) {
    for (std::size_t i = 0; i < header.size(); ++i) {
      if (header[i] != column.name || column.read(row, fields[i])) continue;
      return Error{place, fmt::format("{}: expected a number, found \"{}\"", header[i], fields[i]),
                   "Remove the file to measure everything again."};
    }
  }
  row.alone.receivers = row.total.receivers;
  return row;
}

}  // namespace

std::string formatBenchRows(const std::vector<BenchRow>& rows) {
  std::string text;
  for (const Column& c : columns()) text += fmt::format("{}{}", text.empty() ? "" : ",", c.name);
  text += '\n';
  for (BenchRow row : rows) {
    bool first = true;
    for (const Column& c : columns()) {
      text += (first ? "" : ",") + plain(c.write(row));
      first = false;
    }
    text += '\n';
  }
  return text;
}

Result<std::vector<BenchRow>> parseBenchRows(std::string_view text, const std::string& name) {
  std::vector<BenchRow> rows;
  std::vector<std::string_view> header;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.empty()) continue;
    if (header.empty()) {
      header = fieldsOf(line);
      if (header[0] == "project") continue;
      return Error{name, "this is no table of the bench: its first column is not \"project\"",
                   "Choose another folder with -o."};
    }
    auto row = rowOf(header, line, fmt::format("{}:{}", name, number));
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace soffit::design

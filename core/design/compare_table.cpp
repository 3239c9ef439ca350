// SPDX-License-Identifier: MIT
#include "core/design/compare_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace soffit::design {
namespace {

/// Width of a column of names, by code points.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
  }));
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, widthOf(text)), ' ');
}

std::string percentOf(double difference, double base) {
  return base > 0.0 ? fmt::format("{:+.1f} %", 100.0 * difference / base) : "-";
}

}  // namespace

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string compareText(std::span<const LayoutFigures> layouts) {
  std::string text;
  if (layouts.empty()) return text;
  auto out = std::back_inserter(text);
  std::size_t width = 10;
  for (const LayoutFigures& l : layouts) width = std::max(width, widthOf(l.name) + 2);
  for (std::size_t p = 0; p < layouts[0].planes.size(); ++p) {
    const std::string heading =
        fmt::format("{} ({} points)", layouts[0].planes[p].name, layouts[0].planes[p].lux.count);
    fmt::format_to(out, "{}\n{} {:>9} {:>9} {:>9} {:>6} {:>11} {:>9}\n", heading, padded("", width),
                   "mean lx", "min lx", "max lx", "U0", "against 1st", "");
    const photometry::FieldMetrics& first = layouts[0].planes[p].lux;
    for (std::size_t i = 0; i < layouts.size(); ++i) {
      const photometry::FieldMetrics& m = layouts[i].planes[p].lux;
      fmt::format_to(out, "{} {:>9.1f} {:>9.1f} {:>9.1f} {:>6.2f}", padded(layouts[i].name, width),
                     m.mean, m.min, m.max, m.u0);
      if (i > 0) {
        fmt::format_to(out, " {:>+8.1f} lx {:>9}", m.mean - first.mean,
                       percentOf(m.mean - first.mean, first.mean));
      }
      text += '\n';
    }
    text += '\n';
  }
  fmt::format_to(out, "{} {:>9} {:>12} {:>12} {:>9}\n", padded("Light", width), "lights on",
                 "emitted lm", "installed lm", "lm/m2");
  for (const LayoutFigures& l : layouts) {
    fmt::format_to(out, "{} {:>9} {:>12.0f} {:>12.0f} {:>9}\n", padded(l.name, width),
                   l.luminaires_on, l.emitted_lm, l.installed_lm,
                   l.lm_per_m2 > 0.0 ? fmt::format("{:.1f}", l.lm_per_m2) : "-");
  }
  return text;
}

std::string compareCsv(std::span<const LayoutFigures> layouts) {
  std::string text =
      "layout,work_plane,points,mean_lx,min_lx,max_lx,u0,ud,mean_difference_lx,"
      "mean_difference_percent,min_difference_lx,max_difference_lx,luminaires_on,emitted_lm,"
      "installed_lm,lm_per_m2\n";
  auto out = std::back_inserter(text);
  for (const LayoutFigures& l : layouts) {
    const std::string flux = fmt::format("{},{:.9g},{:.9g},{:.9g}\n", l.luminaires_on, l.emitted_lm,
                                         l.installed_lm, l.lm_per_m2);
    if (l.planes.empty()) fmt::format_to(out, "{},,0,,,,,,,,,,{}", csvField(l.name), flux);
    for (std::size_t p = 0; p < l.planes.size(); ++p) {
      const photometry::FieldMetrics& m = l.planes[p].lux;
      const photometry::FieldMetrics& first = layouts[0].planes[p].lux;
      fmt::format_to(
          out, "{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{},{:.9g},{:.9g},{}",
          csvField(l.name), csvField(l.planes[p].name), m.count, m.mean, m.min, m.max, m.u0, m.ud,
          m.mean - first.mean,
          first.mean > 0.0 ? fmt::format("{:.9g}", 100.0 * (m.mean / first.mean - 1.0)) : "",
          m.min - first.min, m.max - first.max, flux);
    }
  }
  return text;
}

}  // namespace soffit::design

// SPDX-License-Identifier: MIT
#include "app/cli/bench_report.h"

#include "core/design/pareto.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace soffit::cli {
namespace {

/// Which of a row's errors is weighed against its run time.
enum class Judged { alone, total };

double errorOf(const design::BenchRow& row, Judged judged) {
  return judged == Judged::alone ? row.alone.rms : row.total.rms;
}

std::vector<std::string> projectsOf(const std::vector<design::BenchRow>& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) {
    if (std::find(names.begin(), names.end(), row.project) == names.end()) {
      names.push_back(row.project);
    }
  }
  return names;
}

/// Indices of a project's rows on the front.
std::vector<std::size_t> frontOf(const std::vector<design::BenchRow>& rows,
                                 const std::string& project, Judged judged) {
  std::vector<std::size_t> index;
  std::vector<design::Tradeoff> choices;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].project != project) continue;
    index.push_back(i);
    choices.push_back({rows[i].update_ms, errorOf(rows[i], judged)});
  }
  std::vector<std::size_t> front;
  for (const std::size_t k : design::paretoFront(choices)) front.push_back(index[k]);
  return front;
}

std::string shortName(const design::BenchRow& row) {
  return row.method == "bitmask" ? row.settings : row.method;
}

std::string seriesOf(const design::BenchRow& row) {
  if (row.method.rfind("shadow-rays", 0) == 0) return "shadow rays";
  if (row.method == "bitmask") {
    return row.settings.find('+') == std::string::npos ? "bitmask, presets" : "bitmask, settings";
  }
  if (row.method.rfind("harmonics", 0) == 0) return "harmonics";
  if (row.method.rfind("cubes", 0) == 0) return "dynamic cube maps";
  return "nodes alone";
}

ChartPanel panelOf(const std::vector<design::BenchRow>& rows, const std::string& project,
                   Judged judged) {
  ChartPanel panel;
  panel.title =
      project + (judged == Judged::alone ? ": the moved light alone" : ": all luminaires");
  panel.x_label = "update, ms";
  panel.y_label = "RMS error, %";
  std::map<std::string, std::vector<dvec2>> series;
  for (const auto& row : rows) {
    if (row.project != project) continue;
    series[seriesOf(row)].emplace_back(row.update_ms, 100.0 * errorOf(row, judged));
  }
  for (auto& [name, points] : series) panel.series.push_back({name, std::move(points)});
  for (const std::size_t i : frontOf(rows, project, judged)) {
    panel.front.emplace_back(rows[i].update_ms, 100.0 * errorOf(rows[i], judged));
    panel.labels.push_back(shortName(rows[i]));
  }
  return panel;
}

std::set<std::size_t> bestOf(const std::vector<design::BenchRow>& rows) {
  std::set<std::size_t> best;
  for (const std::string& project : projectsOf(rows)) {
    for (const Judged judged : {Judged::alone, Judged::total}) {
      for (const std::size_t i : frontOf(rows, project, judged)) best.insert(i);
    }
  }
  return best;
}

io::Json rowJson(const design::BenchRow& row, bool pareto) {
  const relight::StageTimes& s = row.stages;
  return io::Json::object({{"project", row.project},
                           {"method", row.method},
                           {"settings", row.settings},
                           {"receivers", row.receivers},
                           {"update_ms", row.update_ms},
                           {"update_p99_ms", row.update_p99_ms},
                           {"stages_ms", io::Json::object({{"direct", s.direct},
                                                           {"first_bounce", s.first_bounce},
                                                           {"nodes", s.nodes},
                                                           {"gather", s.gather},
                                                           {"sweep", s.sweep},
                                                           {"interpolate", s.interpolate}})},
                           {"mix_ms", row.mix_ms},
                           {"paint_ms", row.paint_ms},
                           {"rms", row.total.rms},
                           {"p95", row.total.p95},
                           {"bias", row.total.bias},
                           {"reference_stderr", row.total.reference_stderr},
                           {"alone_rms", row.alone.rms},
                           {"alone_p95", row.alone.p95},
                           {"alone_bias", row.alone.bias},
                           {"rays", row.rays},
                           {"rays_avoided", row.rays_avoided},
                           {"bake_s", row.bake_s},
                           {"first_result_s", row.first_result_s},
                           {"operator_bytes", row.operator_bytes},
                           {"peak_bytes", row.peak_bytes},
                           {"pareto", pareto}});
}

io::Json texts(const std::vector<std::string>& lines) {
  io::JsonArray array;
  for (const std::string& line : lines) array.emplace_back(line);
  return array;
}

}  // namespace

std::vector<ChartPanel> benchPanels(const std::vector<design::BenchRow>& rows) {
  std::vector<ChartPanel> panels;
  for (const std::string& project : projectsOf(rows)) {
    panels.push_back(panelOf(rows, project, Judged::alone));
    panels.push_back(panelOf(rows, project, Judged::total));
  }
  return panels;
}

std::string benchText(const std::vector<design::BenchRow>& rows,
                      const std::vector<std::string>& left_out,
                      const std::vector<std::string>& files, double seconds) {
  const std::set<std::size_t> best = bestOf(rows);
  std::string text;
  for (const std::string& project : projectsOf(rows)) {
    text +=
        fmt::format("{:<10} {:<14} {:<28} {:>8} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7}\n",
                    project, "method", "settings", "ms", "mix", "paint", "RMS %", "P95 %", "bias %",
                    "alone %", "bake s", "MB");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const design::BenchRow& r = rows[i];
      if (r.project != project) continue;
      text += fmt::format(
          "{:>10} {:<14} {:<28} {:>8.2f} {:>7.2f} {:>7.1f} {:>7.2f} {:>7.2f} {:>7.2f} {:>7.2f} "
          "{:>7.1f} {:>7.1f}\n",
          best.contains(i) ? "*" : "", r.method, r.settings, r.update_ms, r.mix_ms, r.paint_ms,
          100.0 * r.total.rms, 100.0 * r.total.p95, 100.0 * r.total.bias, 100.0 * r.alone.rms,
          r.bake_s, static_cast<double>(r.operator_bytes) / 1e6);
    }
  }
  text += fmt::format("* on the front of run time against RMS error; {:.0f} s\n", seconds);
  if (!left_out.empty()) {
    text += fmt::format("left out, for want of time: {} points (call again to go on):\n",
                        left_out.size());
    for (const std::string& point : left_out) text += "  " + point + "\n";
  }
  for (const std::string& file : files) text += fmt::format("wrote {}\n", file);
  return text;
}

io::Json benchJson(const std::vector<design::BenchRow>& rows,
                   const std::vector<std::string>& left_out, const std::vector<std::string>& files,
                   double seconds) {
  const std::set<std::size_t> best = bestOf(rows);
  io::JsonArray list;
  for (std::size_t i = 0; i < rows.size(); ++i) list.push_back(rowJson(rows[i], best.contains(i)));
  return io::Json::object({{"seconds", seconds},
                           {"rows", list},
                           {"left_out", texts(left_out)},
                           {"files", texts(files)}});
}

}  // namespace soffit::cli

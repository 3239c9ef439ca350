// SPDX-License-Identifier: MIT
#include "core/design/growth_bench.h"

#include "core/design/growth_room.h"
#include "core/relight/engine.h"
#include "core/relight/lighting.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <utility>

namespace soffit::design {
namespace {

constexpr std::size_t kFewTriangles = 1000;
constexpr std::size_t kUsualTriangles = 10000;  ///< where luminaires grow
constexpr std::size_t kUsualLuminaires = 12;    ///< where triangles grow

double milliseconds(const std::function<void()>& run) {
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

struct Baked {
  std::shared_ptr<const relight::Solver> solver;
  relight::EngineReport report;
};

Result<Baked> bakeRoom(const scene::Scene& room, const GrowthOptions& options, const Job& job) {
  auto quality = relight::qualitySettings(scene::Quality{.preset = options.quality});
  if (!quality) return quality.error();
  quality->bake.seed = options.seed;
  Baked baked;
  // Who asks for a first result gets one.
  auto solver = relight::makeSolver(room, *quality, false, job, baked.report,
                                    [](const std::shared_ptr<const relight::Solver>&) {});
  if (!solver) return solver.error();
  baked.solver = std::move(*solver);
  return baked;
}

/// The light of all luminaires, of one that moves, and of all that are dimmed.
Result<void> measureLight(const std::shared_ptr<const relight::Solver>& solver,
                          const scene::Scene& room, const GrowthOptions& options, const Job& job,
                          GrowthRow& row) {
  relight::Lighting lighting(solver);
  Result<void> set;
  row.all_ms = milliseconds([&] { set = lighting.setLuminaires(room.luminaires, job); });
  if (!set) return set;
  std::vector<double> moves;
  lighting.grab(0);
  for (int i = 0; i < options.moves; ++i) {
    light::Luminaire moved = room.luminaires.front();
    moved.position.x += 0.05 * i;
    const auto emitter = light::makeEmitter(moved, room.mesh->origin);
    if (!emitter) return emitter.error();
    moves.push_back(lighting.move(*emitter).total());
  }
  std::nth_element(moves.begin(), moves.begin() + static_cast<std::ptrdiff_t>(moves.size() / 2),
                   moves.end());
  row.move_ms = moves[moves.size() / 2];
  relight::Planes total;
  row.mix_ms = milliseconds([&] {
    for (std::size_t i = 0; i < lighting.emitters().size(); ++i) {
      lighting.setMix(i, 0.5, dvec3(1.0));
    }
    total = lighting.total();
  });
  return {};
}

GrowthRow rowOf(const char* task, const scene::Scene& room, const Baked& baked) {
  GrowthRow row;
  row.task = task;
  row.triangles = room.mesh->triangleCount();
  row.luminaires = room.luminaires.size();
  row.texels = baked.solver->operators().texels.texelCount();
  row.megabytes = static_cast<double>(baked.report.bytes) / 1.0e6;
  return row;
}

/// Least-squares slope of log(y) over log(x).
double slope(const std::vector<std::pair<double, double>>& points) {
  double x = 0.0;
  double y = 0.0;
  for (const auto& [a, b] : points) {
    x += std::log(a);
    y += std::log(b);
  }
  const auto n = static_cast<double>(points.size());
  double xx = 0.0;
  double xy = 0.0;
  for (const auto& [a, b] : points) {
    xx += (std::log(a) - x / n) * (std::log(a) - x / n);
    xy += (std::log(a) - x / n) * (std::log(b) - y / n);
  }
  return xy / xx;
}

}  // namespace

Result<std::vector<GrowthRow>> measureGrowth(const GrowthOptions& options, const Job& job) {
  std::vector<GrowthRow> rows;
  const auto cancelled = [] { return Error{"bench growth", "cancelled", ""}; };
  for (std::size_t n = kFewTriangles; n <= options.most_triangles; n *= 10) {
    const scene::Scene room = growthRoom(n, kUsualLuminaires);
    const auto baked = bakeRoom(room, options, job);
    if (!baked) return baked.error();
    GrowthRow row = rowOf("triangles", room, *baked);
    row.bake_s = baked->report.bake.seconds;
    row.first_s = baked->report.bake.first_result_seconds;
    const auto measured = measureLight(baked->solver, room, options, job, row);
    if (!measured) return measured.error();
    if (job.cancelled()) return cancelled();
    rows.push_back(row);
  }
  if (options.most_luminaires < 1) return rows;
  const auto baked = bakeRoom(growthRoom(kUsualTriangles, 1), options, job);
  if (!baked) return baked.error();
  for (std::size_t n = 1; n <= options.most_luminaires; n *= 10) {
    const scene::Scene room = growthRoom(kUsualTriangles, n);
    GrowthRow row = rowOf("luminaires", room, *baked);
    const auto measured = measureLight(baked->solver, room, options, job, row);
    if (!measured) return measured.error();
    if (job.cancelled()) return cancelled();
    rows.push_back(row);
  }
  return rows;
}

std::vector<GrowthExponent> growthExponents(const std::vector<GrowthRow>& rows) {
  struct Figure {
    const char* name;
    double GrowthRow::*value;
  };
  constexpr std::array kFigures{
      Figure{"bake_s", &GrowthRow::bake_s},       Figure{"first_s", &GrowthRow::first_s},
      Figure{"megabytes", &GrowthRow::megabytes}, Figure{"all_ms", &GrowthRow::all_ms},
      Figure{"move_ms", &GrowthRow::move_ms},     Figure{"mix_ms", &GrowthRow::mix_ms}};
  std::vector<GrowthExponent> exponents;
  for (const char* task : {"triangles", "luminaires"}) {
    for (const Figure& figure : kFigures) {
      std::vector<std::pair<double, double>> points;
      for (const GrowthRow& row : rows) {
        if (row.task != task || !(row.*figure.value > 0.0)) continue;
        const std::size_t size = row.task == "triangles" ? row.triangles : row.luminaires;
        points.emplace_back(static_cast<double>(size), row.*figure.value);
      }
      if (points.size() >= 2) exponents.push_back({task, figure.name, slope(points)});
    }
  }
  return exponents;
}

std::string formatGrowthRows(const std::vector<GrowthRow>& rows) {
  std::string text =
      "task,triangles,luminaires,texels,bake_s,first_s,megabytes,all_ms,move_ms,mix_ms\n";
  for (const GrowthRow& r : rows) {
    text += fmt::format("{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", r.task,
                        r.triangles, r.luminaires, r.texels, r.bake_s, r.first_s, r.megabytes,
                        r.all_ms, r.move_ms, r.mix_ms);
  }
  return text;
}

}  // namespace soffit::design

// SPDX-License-Identifier: MIT
#include "app/cli/bench_sweep.h"

#include "app/cli/peak_memory.h"
#include "core/design/bench_plan.h"
#include "core/io/project/atomic_file.h"
#include "core/relight/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace soffit::cli {
namespace fs = std::filesystem;
namespace {

/// How much longer than the interactive preset a step takes, roughly: rays of the bake.
double relativeCost(const scene::Quality& quality) {
  const auto settings = relight::qualitySettings(quality);
  const auto usual = relight::qualitySettings({});
  if (!settings || !usual) return 1.0;
  const auto cost = [](const transfer::BakeSettings& s) {
    const double lists = double(s.texels) / 256.0 * s.max_rank * std::pow(s.list_rays, 2);
    const double fields = double(s.texels) * (std::pow(s.field_rays, 2) + std::pow(s.node_rays, 2));
    return lists + fields;
  };
  return cost(settings->bake) / cost(usual->bake);
}

}  // namespace

BenchSweep::BenchSweep(BenchSweepOptions options, Job job)
    : options_(std::move(options)), job_(std::move(job)) {}

Result<void> BenchSweep::resume() {
  if (!fs::exists(tableFile())) return {};
  const auto text = io::readFile(tableFile());
  if (!text) return text.error();
  auto rows = design::parseBenchRows(*text, tableFile().string());
  if (!rows) return rows.error();
  rows_ = std::move(*rows);
  return {};
}

void BenchSweep::add(std::string name, io::Project project) {
  Entry entry;
  entry.name = std::move(name);
  entry.key = design::benchKey(project.scene, options_.receivers, options_.effort);
  entry.project = std::move(project);
  entries_.push_back(std::move(entry));
}

double BenchSweep::secondsSoFar() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool BenchSweep::isCurrent(const design::BenchRow& row) const {
  return row.version == options_.version &&
         std::any_of(entries_.begin(), entries_.end(),
                     [&](const Entry& e) { return e.name == row.project && e.key == row.scene; });
}

std::vector<design::BenchRow> BenchSweep::rows() const {
  std::vector<design::BenchRow> out;
  std::copy_if(rows_.begin(), rows_.end(), std::back_inserter(out),
               [&](const design::BenchRow& row) { return isCurrent(row); });
  return out;
}

std::vector<design::BenchPoint> BenchSweep::pending(const Entry& entry,
                                                    const design::BenchStep& step) const {
  std::vector<design::BenchPoint> out;
  for (const design::BenchPoint& point : step.points) {
    design::BenchRow key;
    key.project = entry.name;
    key.scene = entry.key;
    key.version = options_.version;
    key.method = point.methodName();
    key.settings = point.settingsName();
    const auto done = [&](const design::BenchRow& row) { return row.sameKey(key); };
    if (std::none_of(rows_.begin(), rows_.end(), done)) out.push_back(point);
  }
  return out;
}

std::vector<std::string> BenchSweep::leftOut() const {
  std::vector<std::string> out;
  for (const design::BenchStep& step : design::benchPlan()) {
    for (const Entry& entry : entries_) {
      for (const design::BenchPoint& point : pending(entry, step)) {
        out.push_back(
            fmt::format("{} {} {}", entry.name, point.methodName(), point.settingsName()));
      }
    }
  }
  return out;
}

double BenchSweep::expectedSeconds(const Entry& entry, const design::BenchStep& step) const {
  return entry.unit_seconds * relativeCost(step.quality);
}

Result<void> BenchSweep::provideReference(Entry& entry, const design::BenchEngine& engine) {
  if (entry.bench) return {};
  const fs::path file = options_.folder / fmt::format("reference_{}.csv", entry.name);
  if (fs::exists(file)) {
    const auto text = io::readFile(file);
    if (!text) return text.error();
    auto stored = design::parseBenchCase(*text, file.string());
    if (!stored) return stored.error();
    if (stored->scene == entry.key) {
      entry.bench = std::move(*stored);
      return {};
    }
  }
  design::ReferenceEffort effort = options_.effort;
  // Of the budget, two fifths may go into references.
  effort.time_limit_s =
      std::max(2.0, 0.4 * options_.budget_s / static_cast<double>(entries_.size()));
  auto made =
      design::makeBenchCase(engine.solver, entry.project.scene, options_.receivers, effort, job_);
  if (!made) return made.error();
  made->scene = entry.key;
  entry.bench = std::move(*made);
  return io::writeFileAtomically(file, design::formatBenchCase(*entry.bench));
}

Result<void> BenchSweep::runStep(Entry& entry, const design::BenchStep& step,
                                 const std::vector<design::BenchPoint>& points) {
  const double begin = secondsSoFar();
  resetPeakMemory();
  const auto engine =
      design::makeBenchEngine(entry.project.scene, step.quality, options_.effort.seed, job_);
  if (!engine) return engine.error();
  const std::size_t bake_peak = peakMemory();
  const double baked = secondsSoFar();
  if (auto provided = provideReference(entry, *engine); !provided) return provided;
  for (const design::BenchPoint& point : points) {
    job_.report(fmt::format("{}: {} {}", entry.name, point.methodName(), point.settingsName()),
                std::min(1.0, secondsSoFar() / options_.budget_s));
    // Slow yardsticks of the first step come after what else fits.
    if (secondsSoFar() > options_.budget_s && !rows().empty()) return {};
    auto row = design::measureBench(point, *engine, entry.project.scene, *entry.bench, job_);
    if (!row) return row.error();
    row->project = entry.name;
    row->version = options_.version;
    row->peak_bytes = bake_peak;
    rows_.push_back(std::move(*row));
    auto written = io::writeFileAtomically(tableFile(), design::formatBenchRows(rows_));
    if (!written) return written;
    if (entry.unit_seconds <= 0.0)
      entry.unit_seconds = (baked - begin) / relativeCost(step.quality);
  }
  return {};
}

Result<void> BenchSweep::run() {
  for (const design::BenchStep& step : design::benchPlan()) {
    for (Entry& entry : entries_) {
      const std::vector<design::BenchPoint> points = pending(entry, step);
      if (points.empty()) continue;
      if (secondsSoFar() + expectedSeconds(entry, step) > options_.budget_s) continue;
      const auto done = runStep(entry, step, points);
      if (!done) {
        Error error = done.error();
        error.place = fmt::format("{}: {}", entry.project.path.string(), error.place);
        return error;
      }
    }
  }
  return {};
}

}  // namespace soffit::cli

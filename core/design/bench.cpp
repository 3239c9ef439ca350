// SPDX-License-Identifier: MIT
#include "core/design/bench.h"

#include "core/design/shadow_rays.h"
#include "core/design/surface_reading.h"
#include "core/photometry/metrics.h"
#include "core/prt/local_direct.h"
#include "core/relight/lighting.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <utility>

namespace soffit::design {
namespace {

constexpr std::size_t kWarmUps = 3;
constexpr std::size_t kMoves = 15;
constexpr std::size_t kPaints = 6;
constexpr double kReach = 0.25;             // m around the light's place
constexpr std::uint64_t kRaysAvoided = 64;  // per point, what the bitmask is weighed against

double lux(const dvec3& rgb) {
  return glm::dot(rgb, light::kLuminance);
}

/// Places for timing: on a level circle around the light's own.
dvec3 placeOf(const dvec3& home, std::size_t i, std::size_t count) {
  const double angle = 2.0 * 3.14159265358979 * static_cast<double>(i) / static_cast<double>(count);
  return home + kReach * dvec3(std::cos(angle), std::sin(angle), 0.0);
}

/// Medians over the moves.
void addTimes(const std::vector<relight::StageTimes>& moves, BenchRow& row) {
  const auto quantile = [&](auto value, double q) {
    std::vector<double> all;
    all.reserve(moves.size());
    for (const relight::StageTimes& t : moves) all.push_back(value(t));
    return photometry::percentile(all, q);
  };
  row.update_ms = quantile([](const auto& t) { return t.total(); }, 0.5);
  row.update_p99_ms = quantile([](const auto& t) { return t.total(); }, 0.99);
  row.stages.direct = quantile([](const auto& t) { return t.direct; }, 0.5);
  row.stages.first_bounce = quantile([](const auto& t) { return t.first_bounce; }, 0.5);
  row.stages.nodes = quantile([](const auto& t) { return t.nodes; }, 0.5);
  row.stages.gather = quantile([](const auto& t) { return t.gather; }, 0.5);
  row.stages.sweep = quantile([](const auto& t) { return t.sweep; }, 0.5);
  row.stages.interpolate = quantile([](const auto& t) { return t.interpolate; }, 0.5);
}

/// Measures one point for one light among the others.
class Measurement {
 public:
  Measurement(std::shared_ptr<const relight::Solver> solver, const scene::Scene& scene,
              const BenchCase& bench, std::size_t light)
      : solver_(std::move(solver)),
        scene_(scene),
        bench_(bench),
        light_(light),
        points_(toReceivers(bench.receivers)) {}

  Result<void> withEngine(const Job& job, BenchRow& row) {
    relight::Lighting all(solver_);
    auto set = all.setLuminaires(scene_.luminaires, job);
    if (!set) return set;
    std::vector<light::Luminaire> luminaires = scene_.luminaires;
    for (std::size_t i = 0; i < luminaires.size(); ++i) luminaires[i].on = i == light_;
    relight::Lighting alone(solver_);
    auto set_alone = alone.setLuminaires(luminaires, job);
    if (!set_alone) return set_alone;
    row.total = figures(readSurfaces(all, bench_.receivers), bench_.total);
    row.alone = figures(readSurfaces(alone, bench_.receivers), bench_.alone);
    timeMixes(all, row);
    timePaint(all, row);
    return timeMoves(all, job, row);
  }

  Result<void> run(const BenchPoint& point, const Job& job, BenchRow& row) {
    switch (point.method) {
      case BenchMethod::bitmask:
      case BenchMethod::nodes:
        return withEngine(job, row);
      case BenchMethod::shadow_rays:
        return withDirect(shadowRays(point.rays), point.rays > 16, job, row);
      case BenchMethod::harmonics:
      case BenchMethod::cubes: {
        prt::LocalOptions options;
        options.bands = point.rays;
        if (point.method == BenchMethod::cubes) options.method = prt::LocalMethod::cubes;
        int& resolution =
            point.method == BenchMethod::cubes ? options.cube_side : options.directions;
        if (point.resolution > 0) resolution = point.resolution;
        const auto way = byTransfer(options, job, row);
        if (!way) return way.error();
        return withDirect(*way, true, job, row);
      }
    }
    return {};
  }

  /// Direct light another way than the engine's: at its texels, and at the bench's points.
  struct DirectWay {
    using Stage = std::function<std::uint64_t(const light::Emitter&, std::span<float> lux,
                                              std::span<std::uint8_t> lit)>;  ///< returns rays
    Stage texels;
    Stage points;
  };

  [[nodiscard]] DirectWay shadowRays(int rays) const {
    const auto stage = [this, rays](const light::Receivers& receivers) {
      return [this, rays, &receivers](const light::Emitter& emitter, std::span<float> lux,
                                      std::span<std::uint8_t> lit) {
        return shadowRayIlluminance(emitter, receivers, solver_->scene().caster, rays, lux, lit);
      };
    };
    return {stage(texels()), stage(points_)};
  }

  /// By a method of the founding papers; what it precomputes counts with the bake.
  [[nodiscard]] Result<DirectWay> byTransfer(const prt::LocalOptions& options, const Job& job,
                                             BenchRow& row) const {
    const auto surfaces = prt::makeSurfaces(scene_.mesh, scene_.materials);
    const auto start = std::chrono::steady_clock::now();
    const auto at_texels = prt::LocalDirect::make(*surfaces, texels(), options, job);
    if (!at_texels) return at_texels.error();
    const auto passed = std::chrono::steady_clock::now() - start;
    row.bake_s += std::chrono::duration<double>(passed).count();
    row.bake_rays += (*at_texels)->rays();
    row.operator_bytes += (*at_texels)->bytes();
    const auto at_points = prt::LocalDirect::make(*surfaces, points_, options, job);
    if (!at_points) return at_points.error();
    const auto stage = [](std::shared_ptr<const prt::LocalDirect> method) {
      return [method = std::move(method)](const light::Emitter& emitter, std::span<float> lux,
                                          std::span<std::uint8_t> lit) {
        method->illuminate(emitter, lux, lit);
        return std::uint64_t{0};
      };
    };
    return DirectWay{stage(*at_texels), stage(*at_points)};
  }

  Result<void> withDirect(const DirectWay& way, bool slow, const Job& job, BenchRow& row) {
    std::vector<relight::SensorLight> total(bench_.receivers.size());
    for (std::size_t i = 0; i < scene_.luminaires.size(); ++i) {
      if (job.cancelled()) return Error{"bench", "cancelled", ""};
      const auto emitter = light::makeEmitter(scene_.luminaires[i], scene_.mesh->origin);
      if (!emitter) return emitter.error();
      if (emitter->gain <= 0.0) continue;
      const auto one = read(*emitter, way);
      for (std::size_t k = 0; k < total.size(); ++k) {
        total[k].direct += one[k].direct;
        total[k].indirect += one[k].indirect;
      }
      if (i == light_) row.alone = figures(one, bench_.alone);
    }
    row.total = figures(total, bench_.total);
    // Slow methods are timed at fewer places.
    const std::size_t count = slow ? kMoves / 3 : kMoves;
    std::vector<relight::StageTimes> times;
    relight::Planes sum;
    for (std::size_t i = 0; i < count + 1; ++i) {
      if (job.cancelled()) return Error{"bench", "cancelled", ""};
      const auto emitter = emitterAt(placeOf(home(), i, count));
      if (!emitter) return emitter.error();
      relight::StageTimes t;
      relight::Column column;
      row.rays = columnOf(*emitter, way, column, &t);
      const auto start = std::chrono::steady_clock::now();
      const relight::WeightedColumn own{&column, emitter->gain * emitter->color};
      relight::spread({}, {&own, 1}, solver_->operators(), sum);
      const auto passed = std::chrono::steady_clock::now() - start;
      t.interpolate = std::chrono::duration<double, std::milli>(passed).count();
      if (i > 0) times.push_back(t);
    }
    addTimes(times, row);
    return {};
  }

 private:
  [[nodiscard]] const dvec3& home() const { return scene_.luminaires[light_].position; }

  [[nodiscard]] Result<light::Emitter> emitterAt(const dvec3& place) const {
    light::Luminaire moved = scene_.luminaires[light_];
    moved.position = place;
    return light::makeEmitter(moved, scene_.mesh->origin);
  }

  static ErrorFigures figures(const std::vector<relight::SensorLight>& light,
                              const ErrorSamples& reference) {
    ErrorSamples samples;
    for (std::size_t i = 0; i < light.size(); ++i) {
      samples.add(lux(light[i].direct + light[i].indirect), reference.reference[i],
                  reference.standard_error[i]);
    }
    return errorFigures(samples);
  }

  static double medianMs(std::size_t count, const std::function<void(std::size_t)>& run) {
    std::vector<double> all;
    for (std::size_t i = 0; i < count; ++i) {
      const auto start = std::chrono::steady_clock::now();
      run(i);
      const auto passed = std::chrono::steady_clock::now() - start;
      if (i > 0) all.push_back(std::chrono::duration<double, std::milli>(passed).count());
    }
    return photometry::percentile(all, 0.5);
  }

  /// No two luminaires change by the same factor: nothing that was summed before serves.
  static void timeMixes(const relight::Lighting& all, BenchRow& row) {
    relight::Lighting mixed = all;
    row.mix_ms = medianMs(kMoves, [&](std::size_t run) {
      for (std::size_t i = 0; i < all.emitters().size(); ++i) {
        const light::Emitter& e = all.emitters()[i];
        const double factor = 0.3 + 0.7 * std::abs(std::sin(static_cast<double>(run + 7 * i)));
        mixed.setMix(i, factor * e.gain, e.color);
      }
      (void)mixed.total();
    });
  }

  void timePaint(const relight::Lighting& all, BenchRow& row) const {
    row.paint_ms = medianMs(kPaints, [&](std::size_t run) {
      std::vector<scene::Material> materials = scene_.materials;
      for (scene::Material& m : materials) m.diffuse *= 1.0 - 0.05 * static_cast<double>(run + 1);
      (void)all.totalUnder(*solver_->repainted(materials));
    });
  }

  Result<void> timeMoves(relight::Lighting& lighting, const Job& job, BenchRow& row) {
    lighting.grab(light_);
    std::vector<relight::StageTimes> times;
    light::DirectCounts counts;
    for (std::size_t i = 0; i < kWarmUps + kMoves; ++i) {
      if (job.cancelled()) return Error{"bench", "cancelled", ""};
      const auto emitter = emitterAt(placeOf(home(), i, kMoves));
      if (!emitter) return emitter.error();
      const bool counted = i >= kWarmUps;
      const relight::StageTimes t = lighting.move(*emitter, counted ? &counts : nullptr);
      if (counted) times.push_back(t);
    }
    row.rays_avoided = counts.points * kRaysAvoided / kMoves;
    addTimes(times, row);
    return {};
  }

  [[nodiscard]] const light::Receivers& texels() const {
    return solver_->operators().texels.receivers;
  }

  /// Direct light at all texels and the bounces of it; returns the rays.
  std::uint64_t columnOf(const light::Emitter& emitter, const DirectWay& way,
                         relight::Column& column, relight::StageTimes* times) const {
    column.direct.resize(texels().slotCount());
    column.lit.resize(texels().clusters.size());
    const auto start = std::chrono::steady_clock::now();
    const std::uint64_t traced = way.texels(emitter, column.direct, column.lit);
    if (times != nullptr) {
      const auto passed = std::chrono::steady_clock::now() - start;
      times->direct = std::chrono::duration<double, std::milli>(passed).count();
    }
    solver_->indirect(column, {}, nullptr, times);
    return traced;
  }

  [[nodiscard]] std::vector<relight::SensorLight> read(const light::Emitter& emitter,
                                                       const DirectWay& way) const {
    relight::Column column;
    columnOf(emitter, way, column, nullptr);
    column.direct.clear();
    relight::Planes indirect;
    const dvec3 weight = emitter.gain * emitter.color;
    const relight::WeightedColumn own{&column, weight};
    relight::spread({}, {&own, 1}, solver_->operators(), indirect, relight::LightPart::reflected);
    const auto bounced = interpolateAt(solver_->operators().texels, indirect, bench_.receivers);
    std::vector<float> direct(points_.slotCount());
    std::vector<std::uint8_t> lit(points_.clusters.size());
    way.points(emitter, direct, lit);
    std::vector<relight::SensorLight> out(bench_.receivers.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = {weight * static_cast<double>(direct[points_.slot_of[i]]), bounced[i]};
    }
    return out;
  }

  std::shared_ptr<const relight::Solver> solver_;
  const scene::Scene& scene_;
  const BenchCase& bench_;
  std::size_t light_;
  light::Receivers points_;  ///< the bench's
};

}  // namespace

Result<BenchEngine> makeBenchEngine(const scene::Scene& scene, const scene::Quality& quality,
                                    std::uint64_t seed, const Job& job) {
  auto settings = relight::qualitySettings(quality);
  if (!settings) return settings.error();
  settings->bake.seed = seed;
  BenchEngine engine;
  auto solver = relight::makeSolver(scene, *settings, false, job, engine.report,
                                    [&](auto coarse) { engine.coarse = std::move(coarse); });
  if (!solver) return solver.error();
  engine.solver = *solver;
  return engine;
}

Result<BenchRow> measureBench(const BenchPoint& point, const BenchEngine& engine,
                              const scene::Scene& scene, const BenchCase& bench, const Job& job) {
  BenchRow row;
  row.scene = bench.scene;
  row.method = point.methodName();
  row.settings = point.settingsName();
  row.light = bench.light;
  row.receivers = engine.solver->operators().texels.texelCount();
  row.bake_s = engine.report.bake.seconds;
  row.first_result_s = engine.report.bake.first_result_seconds;
  row.bake_rays = engine.report.bake.rays;
  row.operator_bytes = engine.report.bytes;
  const bool nodes = point.method == BenchMethod::nodes && engine.coarse != nullptr;
  if (nodes) {
    row.bake_s = engine.report.bake.coarse_seconds;
    row.operator_bytes = engine.coarse->operators().bytes();
  }
  std::size_t light = 0;
  while (light < scene.luminaires.size() && scene.luminaires[light].name != bench.light) ++light;
  if (light == scene.luminaires.size()) {
    return Error{"bench", "the stored reference belongs to another project",
                 "Choose another folder with -o."};
  }
  Measurement measurement(nodes ? engine.coarse : engine.solver, scene, bench, light);
  const auto done = measurement.run(point, job, row);
  if (!done) return done.error();
  return row;
}

}  // namespace soffit::design

// SPDX-License-Identifier: MIT
#include "core/reference/estimate.h"

#include "core/base/parallel.h"
#include "core/math/rng.h"
#include "core/reference/placement.h"
#include "core/reference/tracer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>

namespace soffit::reference {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kSafeReplicates = 2;  // are made whatever the time limit

/// Running mean and spread of a sensor's replicates (Welford 1962).
struct Accumulator {
  int count = 0;
  dvec3 direct{0.0};
  dvec3 indirect{0.0};
  double mean = 0.0;     ///< of the total luminance
  double squares = 0.0;  ///< sum of squared deviations

  void add(const Tally& tally) {
    ++count;
    direct += (tally.direct - direct) / double(count);
    indirect += (tally.indirect - indirect) / double(count);
    const double total = glm::dot(tally.direct + tally.indirect, light::kLuminance);
    const double delta = total - mean;
    mean += delta / count;
    squares += delta * (total - mean);
  }
  [[nodiscard]] double standardError() const {
    return count > 1 ? std::sqrt(squares / (double(count) * (count - 1))) : 0.0;
  }
};

/// One replicate to trace.
struct Task {
  std::uint32_t sensor;
  std::uint32_t replicate;
};

std::uint64_t streamOf(std::uint64_t seed, const Task& task) {
  return mixBits(mixBits(seed ^ 0x5bd1e995c3a1f7e3ULL) +
                 (static_cast<std::uint64_t>(task.sensor) << 32U | task.replicate));
}

/// Smaller replicates where a rough answer is wanted, so that the least number of them is not
/// more work than needed: about (1 / R)^2 paths of relative spread 1 in all.
std::uint32_t pathsPerReplicate(const EstimateOptions& options) {
  if (options.paths_per_replicate > 0) {
    return static_cast<std::uint32_t>(options.paths_per_replicate);
  }
  const double wanted = 0.5 / (options.relative_error * options.relative_error);
  const double each = wanted / std::max(options.min_replicates, 2);
  std::uint32_t paths = 64;
  while (paths < 1024 && paths < each) paths *= 2;
  return paths;
}

class Estimator {
 public:
  Estimator(const ReferenceScene& scene, std::span<const scene::Sensor> sensors,
            const EstimateOptions& options, const Job& job)
      : scene_(scene),
        sensors_(sensors),
        origins_(placeSensors(scene.mesh(), sensors)),
        options_(options),
        job_(job),
        paths_(pathsPerReplicate(options)),
        accumulators_(sensors.size()) {}

  Estimate run() {
    const int first = std::max(options_.min_replicates, kSafeReplicates);
    job_.report("tracing reference paths", 0.0);
    std::vector<Task> tasks;
    // Replicate by replicate, so that an interruption leaves all sensors equally well known.
    for (int r = 0; r < first; ++r) {
      for (std::uint32_t s = 0; s < sensors_.size(); ++s) {
        tasks.push_back({s, static_cast<std::uint32_t>(r)});
      }
    }
    bool complete = trace(tasks);
    while (complete && plan(tasks)) complete = trace(tasks);
    return result(complete);
  }

 private:
  [[nodiscard]] bool outOfTime() const {
    return options_.time_limit_s > 0.0 && secondsSoFar() > options_.time_limit_s;
  }
  [[nodiscard]] double secondsSoFar() const {
    return std::chrono::duration<double>(Clock::now() - begin_).count();
  }

  /// Traces the tasks and adds what was done in their order; false when something was left out.
  bool trace(const std::vector<Task>& tasks) {
    std::vector<Tally> tallies(tasks.size());
    std::vector<std::uint8_t> done(tasks.size(), 0);
    parallelFor(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (job_.cancelled() || (tasks[i].replicate >= kSafeReplicates && outOfTime())) return;
        const scene::Sensor& sensor = sensors_[tasks[i].sensor];
        Tracer tracer(scene_, origins_[tasks[i].sensor],
                      Response(options_.quantity, sensor.normal));
        tallies[i] = tracer.run(paths_, streamOf(options_.seed, tasks[i]));
        done[i] = 1;
      }
    });
    bool complete = true;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (done[i] == 0) {
        complete = false;
        continue;
      }
      accumulators_[tasks[i].sensor].add(tallies[i]);
      rays_ += tallies[i].rays;
      paths_traced_ += paths_;
    }
    return complete;
  }

  [[nodiscard]] double meanOverSensors() const {
    double sum = 0.0;
    for (const Accumulator& a : accumulators_) sum += a.mean;
    return accumulators_.empty() ? 0.0 : sum / double(accumulators_.size());
  }

  [[nodiscard]] double target(const Accumulator& a, double mean) const {
    return options_.relative_error * std::max(a.mean, options_.floor_of_mean * mean);
  }

  /// The next round: as many replicates as each sensor is expected to need, at most doubling it,
  /// since a spread of few replicates is uncertain. False when nothing is left to do.
  bool plan(std::vector<Task>& tasks) {
    tasks.clear();
    const double mean = meanOverSensors();
    double need = 0.0;
    double have = 0.0;
    for (std::uint32_t s = 0; s < accumulators_.size(); ++s) {
      const Accumulator& a = accumulators_[s];
      const double goal = target(a, mean);
      have += a.count;
      need += a.count;
      if (!(a.standardError() > goal)) continue;
      const double ratio = a.standardError() / goal;
      const double wanted = 1.05 * a.count * ratio * ratio;
      need += wanted - a.count;
      double count = std::ceil(std::clamp(wanted, a.count + 1.0, 2.0 * a.count));
      if (options_.max_paths > 0) {
        count = std::min(count, std::floor(double(options_.max_paths) / paths_));
      }
      for (auto r = static_cast<std::uint32_t>(a.count); r < count; ++r) tasks.push_back({s, r});
    }
    job_.report("tracing reference paths", need > 0.0 ? have / need : 1.0);
    std::stable_sort(tasks.begin(), tasks.end(),
                     [](const Task& a, const Task& b) { return a.replicate < b.replicate; });
    return !tasks.empty();
  }

  [[nodiscard]] Estimate result(bool complete) const {
    Estimate out;
    const double mean = meanOverSensors();
    out.reached = complete;
    for (const Accumulator& a : accumulators_) {
      SensorEstimate e;
      e.direct_rgb = a.direct;
      e.indirect_rgb = a.indirect;
      e.direct = glm::dot(a.direct, light::kLuminance);
      e.indirect = glm::dot(a.indirect, light::kLuminance);
      e.total = e.direct + e.indirect;
      e.standard_error = a.standardError();
      e.replicates = a.count;
      if (e.standard_error > target(a, mean)) out.reached = false;
      out.sensors.push_back(e);
    }
    out.rays = rays_;
    out.paths = paths_traced_;
    out.seconds = secondsSoFar();
    return out;
  }

  const ReferenceScene& scene_;
  std::span<const scene::Sensor> sensors_;
  std::vector<dvec3> origins_;
  const EstimateOptions& options_;
  const Job& job_;
  std::uint32_t paths_;
  std::vector<Accumulator> accumulators_;
  std::uint64_t rays_ = 0;
  std::uint64_t paths_traced_ = 0;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace

Estimate estimate(const ReferenceScene& scene, std::span<const scene::Sensor> sensors,
                  const EstimateOptions& options, const Job& job) {
  return Estimator(scene, sensors, options, job).run();
}

}  // namespace soffit::reference

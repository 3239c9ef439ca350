// SPDX-License-Identifier: MIT
#include "core/design/verify_points.h"

#include "core/design/surface_reading.h"
#include "core/math/rng.h"
#include "core/reference/estimate.h"
#include "core/relight/lighting.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace soffit::design {
namespace {

LightParts sumOf(const LightParts& a, const LightParts& b) {
  return {a.direct + b.direct, a.indirect + b.indirect};
}

SetSamples sumOf(const SetSamples& a, const SetSamples& b) {
  SetSamples sum;
  for (std::size_t i = 0; i < a.lux.size(); ++i) {
    sum.lux.add(a.lux.value[i] + b.lux.value[i], a.lux.reference[i] + b.lux.reference[i],
                std::hypot(a.lux.standard_error[i], b.lux.standard_error[i]));
    sum.value.push_back(sumOf(a.value[i], b.value[i]));
    sum.reference.push_back(sumOf(a.reference[i], b.reference[i]));
  }
  return sum;
}

/// Readings whose reference is still to come.
SetSamples samplesOf(std::span<const relight::SensorLight> readings) {
  SetSamples out;
  for (const relight::SensorLight& r : readings) {
    const LightParts parts{glm::dot(r.direct, light::kLuminance),
                           glm::dot(r.indirect, light::kLuminance)};
    out.lux.add(parts.direct + parts.indirect, 0.0, 0.0);
    out.value.push_back(parts);
  }
  out.reference.resize(out.value.size());
  return out;
}

/// Points that are estimated together.
struct Batch {
  std::vector<scene::Sensor> sensors;
  std::vector<std::size_t> index;
  SetSamples* into = nullptr;
};

/// Sensors by group, each with where its reference goes.
std::vector<Batch> batchesOf(std::span<const scene::Sensor> sensors,
                             std::span<const std::size_t> groups, SetSamples& into) {
  std::vector<Batch> batches;
  const std::set<std::size_t> names(groups.begin(), groups.end());
  for (const std::size_t name : names) {
    Batch batch;
    batch.into = &into;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
      if (groups[i] != name) continue;
      batch.sensors.push_back(sensors[i]);
      batch.index.push_back(i);
    }
    batches.push_back(std::move(batch));
  }
  return batches;
}

}  // namespace

Result<std::vector<SurfaceReceiver>> chooseReceivers(
    const std::shared_ptr<const relight::Solver>& solver, const scene::Scene& scene,
    std::size_t count, std::uint64_t seed, const Job& job) {
  const auto reference = reference::ReferenceScene::make(
      scene, scene.luminaires,
      std::shared_ptr<const geometry::RayCaster>(solver, &solver->scene().caster));
  if (!reference) return reference.error();
  const auto lit = [&](std::span<const SurfaceReceiver> candidates) {
    std::vector<scene::Sensor> sensors;
    for (const SurfaceReceiver& r : candidates) sensors.push_back(toSensor(r, scene.mesh->origin));
    reference::EstimateOptions few;
    few.relative_error = 0.5;
    few.min_replicates = 2;
    few.paths_per_replicate = 64;
    few.max_paths = 128;
    few.seed = seed;
    std::vector<bool> out;
    for (const auto& s : reference::estimate(*reference, sensors, few, job).sensors) {
      out.push_back(s.total > 0.0);
    }
    return out;
  };
  // Twice as many as wanted, so that there are enough when half of the model is dark.
  const auto drawn = drawReceivers(*solver, 2 * count, seed);
  if (job.cancelled()) return Error{"verify", "cancelled", ""};
  return litReceivers(drawn, count, lit);
}

PointSamples sumOf(const PointSamples& a, const PointSamples& b) {
  return {sumOf(a.surfaces, b.surfaces), sumOf(a.sensors, b.sensors)};
}

VerifyPoints::VerifyPoints(std::shared_ptr<const relight::Solver> solver, const scene::Scene& scene,
                           std::vector<SurfaceReceiver> surfaces,
                           std::vector<scene::Sensor> sensors, int sensor_rays,
                           const ReferenceEffort& effort)
    : solver_(std::move(solver)),
      scene_(scene),
      surfaces_(std::move(surfaces)),
      sensors_(std::move(sensors)),
      effort_(effort),
      surface_groups_(surfaces_.size(), 0),
      sensor_groups_(sensors_.size(), 0) {
  if (!sensors_.empty()) {
    prepared_.emplace(*solver_, sensors_, relight::Quantity::planar, sensor_rays, effort.seed);
  }
}

void VerifyPoints::setGroups(std::vector<std::size_t> of_surfaces,
                             std::vector<std::size_t> of_sensors) {
  surface_groups_ = std::move(of_surfaces);
  sensor_groups_ = std::move(of_sensors);
  surface_groups_.resize(surfaces_.size(), 0);
  sensor_groups_.resize(sensors_.size(), 0);
}

Result<void> VerifyPoints::addReference(std::span<const light::Luminaire> luminaires, bool outside,
                                        double seconds, const Job& job, PointSamples& out) {
  // The caster lives in the engine's static scene: share its ownership.
  const auto scene = reference::ReferenceScene::make(
      scene_, luminaires,
      std::shared_ptr<const geometry::RayCaster>(solver_, &solver_->scene().caster), outside);
  if (!scene) return scene.error();
  std::vector<scene::Sensor> on_surfaces;
  for (const SurfaceReceiver& r : surfaces_) {
    on_surfaces.push_back(toSensor(r, scene_.mesh->origin));
  }
  std::vector<Batch> batches = batchesOf(on_surfaces, surface_groups_, out.surfaces);
  for (Batch& b : batchesOf(sensors_, sensor_groups_, out.sensors)) batches.push_back(std::move(b));
  std::size_t left = surfaces_.size() + sensors_.size();
  double time_left = seconds;
  for (const Batch& batch : batches) {
    reference::EstimateOptions options;
    options.relative_error = effort_.error;
    options.floor_of_mean = kFloorOfMean;
    options.seed = mixBits(effort_.seed + 0x9e3779b97f4a7c15ULL * ++calls_);
    if (effort_.time_limit_s > 0.0) {
      const double share = static_cast<double>(batch.sensors.size()) / static_cast<double>(left);
      options.time_limit_s = std::max(1e-3, time_left * share);
    }
    const reference::Estimate found = reference::estimate(*scene, batch.sensors, options, job);
    if (job.cancelled()) return Error{"verify", "cancelled", ""};
    left -= batch.sensors.size();
    time_left -= found.seconds;
    seconds_spent_ += found.seconds;
    rays_ += found.rays;
    reached_ = reached_ && found.reached;
    for (std::size_t k = 0; k < batch.index.size(); ++k) {
      const reference::SensorEstimate& e = found.sensors[k];
      batch.into->lux.reference[batch.index[k]] = e.total;
      batch.into->lux.standard_error[batch.index[k]] = e.standard_error;
      batch.into->reference[batch.index[k]] = {e.direct, e.indirect};
    }
  }
  return {};
}

Result<PointSamples> VerifyPoints::evaluate(std::span<const light::Luminaire> luminaires,
                                            std::size_t evaluations_left, const Job& job,
                                            bool outside) {
  relight::Lighting lighting(solver_);
  const auto set = lighting.setLuminaires(luminaires, job);
  if (!set) return set.error();
  if (outside && scene_.environment) {
    const auto shone =
        lighting.setEnvironment(std::make_shared<daylight::Environment>(*scene_.environment), job);
    if (!shone) return shone.error();
  }
  PointSamples out;
  out.surfaces = samplesOf(readSurfaces(lighting, surfaces_));
  if (prepared_) out.sensors = samplesOf(lighting.read(*prepared_));
  const double left = std::max(0.0, effort_.time_limit_s - seconds_spent_);
  const auto added =
      addReference(luminaires, outside, left / static_cast<double>(evaluations_left), job, out);
  if (!added) return added.error();
  return out;
}

}  // namespace soffit::design

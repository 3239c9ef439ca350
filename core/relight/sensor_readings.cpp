// SPDX-License-Identifier: MIT
#include "core/relight/sensor_readings.h"

#include "core/relight/bodies.h"
#include "core/relight/outdoors.h"
#include "core/relight/same_light.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace soffit::relight {
namespace {

/// A grid of 300 points takes 10 kB per luminaire.
constexpr std::size_t kMostResponses = 2048;

std::vector<light::MaskBlocker> bodiesOfOthers(std::span<const light::Emitter> emitters,
                                               std::size_t i) {
  std::vector<light::MaskBlocker> out;
  for (std::size_t k = 0; k < emitters.size(); ++k) {
    // Its own body does not block a luminaire's light, except that a mesh shades itself.
    if (k == i && emitters[k].kind != light::EmitterKind::mesh) continue;
    const auto body = bodyBlockers(emitters[k]);
    out.insert(out.end(), body.begin(), body.end());
  }
  return out;
}

}  // namespace

SensorReadings::SensorReadings(std::vector<scene::Sensor> sensors, int rays, std::uint64_t seed)
    : points_(std::move(sensors)), rays_(rays), seed_(seed) {}

void SensorReadings::setSolver(std::shared_ptr<const Solver> solver) {
  if (solver == solver_) return;
  const bool same_rays = solver_ != nullptr && solver != nullptr && sensors_ &&
                         &solver_->operators() == &solver->operators();
  responses_.clear();
  outdoors_.clear();
  bodies_.clear();
  solver_ = std::move(solver);
  if (!same_rays) sensors_.reset();
  if (!sensors_ && solver_ != nullptr) {
    sensors_.emplace(*solver_, points_, Quantity::planar, rays_, seed_);
  }
}

void SensorReadings::dropIfBodiesChanged(std::span<const light::Emitter> emitters) {
  std::vector<light::Emitter> bodies;
  std::ranges::copy_if(emitters, std::back_inserter(bodies), &light::Emitter::casts_shadow);
  // A body anywhere changes the shadows of all.
  if (!std::ranges::equal(bodies, bodies_, sameLight)) {
    responses_.clear();
    outdoors_.clear();
  }
  bodies_ = std::move(bodies);
}

const SensorReadings::Response& SensorReadings::responseTo(std::span<const light::Emitter> emitters,
                                                           std::size_t i,
                                                           std::span<const float> open) {
  const auto known = std::ranges::find_if(
      responses_, [&](const Response& r) { return sameLight(r.emitter, emitters[i]); });
  if (known != responses_.end()) {
    responses_.splice(responses_.begin(), responses_, known);
    return responses_.front();
  }
  const auto bodies = bodiesOfOthers(emitters, i);
  Response response;
  response.emitter = emitters[i];
  response.direct = sensors_->direct(*solver_, emitters[i], bodies);
  Column column;
  std::vector<vec4> source;
  solver_->direct(emitters[i], bodies, column);
  solver_->indirect(column, open, &source);
  response.indirect = sensors_->indirect(source);
  responses_.push_front(std::move(response));
  if (responses_.size() > kMostResponses) responses_.pop_back();
  return responses_.front();
}

Result<void> SensorReadings::ensureOutside(
    const std::shared_ptr<const daylight::Environment>& outside,
    std::span<const light::Emitter> emitters, std::span<const float> open, const Job& job) {
  if (outside == nullptr || outside->dark()) {
    outdoors_.clear();
    return {};
  }
  if (outside == outside_ && !outdoors_.empty()) return {};
  std::vector<light::MaskBlocker> bodies;
  for (const light::Emitter& e : emitters) {
    const auto body = bodyBlockers(e);
    bodies.insert(bodies.end(), body.begin(), body.end());
  }
  Outdoors light = outdoorLight(*solver_, outside, bodies, job);
  if (job.cancelled()) return Error{"sensors", "cancelled", ""};
  const std::vector<dvec3> direct = sensors_->outdoors(*solver_, *outside, bodies, job);
  if (job.cancelled()) return Error{"sensors", "cancelled", ""};
  std::vector<SensorLight> found(points_.size());
  for (std::size_t k = 0; k < found.size(); ++k) found[k].direct = direct[k];
  for (std::size_t c = 0; c < light.columns.size(); ++c) {
    std::vector<vec4> source;
    solver_->indirect(light.columns[c], open, &source);
    const std::vector<dvec3> indirect = sensors_->indirect(source);
    for (std::size_t k = 0; k < found.size(); ++k) {
      found[k].indirect += light.weight(c) * indirect[k];
    }
  }
  outdoors_ = std::move(found);
  outside_ = outside;
  return {};
}

Result<std::vector<SensorLight>> SensorReadings::read(
    std::span<const light::Emitter> emitters,
    const std::shared_ptr<const daylight::Environment>& outside, const Job& job) {
  if (!sensors_) return Error{"sensors", "there is no light transport yet", "Precompute first."};
  dropIfBodiesChanged(emitters);
  const std::vector<float> open = openShare(emitters, solver_->operators().texels);
  if (auto shone = ensureOutside(outside, emitters, open, job); !shone) return shone.error();
  std::vector<SensorLight> out = outdoors_;
  out.resize(points_.size());
  for (std::size_t i = 0; i < emitters.size(); ++i) {
    if (job.cancelled()) return Error{"sensors", "cancelled", ""};
    if (emitters[i].gain <= 0.0) continue;
    const Response& response = responseTo(emitters, i, open);
    const dvec3 weight = emitters[i].gain * emitters[i].color;
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k].direct += weight * response.direct[k];
      out[k].indirect += weight * response.indirect[k];
    }
  }
  return out;
}

}  // namespace soffit::relight

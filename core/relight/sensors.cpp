// SPDX-License-Identifier: MIT
#include "core/relight/sensors.h"

#include "core/base/parallel.h"
#include "core/math/sampling.h"
#include "core/relight/direct_light.h"
#include "core/relight/outdoors.h"
#include "core/transfer/hemisphere.h"
#include "core/transfer/kernels.h"

#include <algorithm>
#include <cmath>

namespace soffit::relight {
namespace {

/// Orientations whose mean of planar illuminance is the quantity. Midpoint rules: on a circle they
/// converge exponentially for light without edges, on the sphere the spiral's error is O(1/K).
std::vector<dvec3> orientationsOf(const dvec3& n, Quantity quantity) {
  dvec3 t;
  dvec3 b;
  orthonormalBasis(n, t, b);
  std::vector<dvec3> out;
  switch (quantity) {
    case Quantity::planar:
      return {n};
    case Quantity::cylindrical: {
      constexpr int kCount = 24;
      for (int i = 0; i < kCount; ++i) {
        const double phi = 2.0 * kPi * (i + 0.5) / kCount;
        out.push_back(std::cos(phi) * t + std::sin(phi) * b);
      }
      return out;
    }
    case Quantity::semicylindrical: {
      constexpr int kCount = 24;
      const dvec3 up(0.0, 0.0, 1.0);
      dvec3 side = glm::cross(up, n);
      side = glm::length(side) > 1e-9 ? glm::normalize(side) : t;
      for (int i = 0; i < kCount; ++i) {
        const double phi = kPi * ((i + 0.5) / kCount - 0.5);
        out.push_back(std::cos(phi) * n + std::sin(phi) * side);
      }
      return out;
    }
    case Quantity::spherical:
    case Quantity::hemispherical: {
      constexpr int kCount = 64;
      const double lowest = quantity == Quantity::spherical ? -1.0 : 0.0;
      for (int i = 0; i < kCount; ++i) {
        const double z = lowest + (1.0 - lowest) * (i + 0.5) / kCount;
        const double phi = 2.399963229728653 * i;  // golden angle
        const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
        out.push_back(r * std::cos(phi) * t + r * std::sin(phi) * b + z * n);
      }
      return out;
    }
  }
  return {n};
}

}  // namespace

Sensors::Sensors(const Solver& solver, std::span<const scene::Sensor> sensors, Quantity quantity,
                 int rays, std::uint64_t seed)
    : count_(sensors.size()) {
  const dvec3 origin = solver.scene().mesh->origin;
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  for (const scene::Sensor& s : sensors) {
    const std::vector<dvec3> directions = orientationsOf(s.normal, quantity);
    orientations_ = directions.size();
    for (const dvec3& n : directions) {
      positions.emplace_back(s.position - origin);
      normals.emplace_back(n);
    }
  }
  if (positions.empty()) return;
  receivers_ = light::makeReceivers(positions, normals, 64);
  const transfer::Operators& op = solver.operators();
  if (op.texels.slotCount() == 0) return;
  if (orientations_ > 1)
    rays = std::max(8, rays * 2 / static_cast<int>(std::sqrt(orientations_)) / 4 * 4);
  // In chunks, put together in order: the lists are the same for any number of threads.
  constexpr std::size_t kChunk = 32;
  std::vector<transfer::GatherLists> parts((positions.size() + kChunk - 1) / kChunk);
  parallelFor(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    transfer::HemisphereScratch scratch;
    transfer::HemisphereHits hits;
    for (std::size_t part = begin; part < end; ++part) {
      for (std::size_t i = part * kChunk; i < std::min(positions.size(), (part + 1) * kChunk);
           ++i) {
        transfer::traceHemisphere(solver.scene(), op.texels, positions[i], normals[i], rays,
                                  seed * 86028121U + i, 0.0F, scratch, hits);
        parts[part].append(hits.slots);
      }
    }
  });
  for (const transfer::GatherLists& part : parts) lists_.append(part);
}

std::vector<double> Sensors::direct(const Solver& solver, const light::Emitter& emitter,
                                    std::span<const light::MaskBlocker> bodies) const {
  std::vector<float> lux(receivers_.slotCount());
  std::vector<std::uint8_t> lit(receivers_.clusters.size());
  directLight(solver.scene(), light::PreparedLight(emitter), receivers_, bodies, lux, lit);
  std::vector<double> out(count_, 0.0);
  for (std::size_t i = 0; i < count_; ++i) {
    for (std::size_t k = 0; k < orientations_; ++k) {
      out[i] += static_cast<double>(lux[receivers_.slot_of[i * orientations_ + k]]);
    }
    out[i] /= static_cast<double>(orientations_);
  }
  return out;
}

std::vector<dvec3> Sensors::outdoors(const Solver& solver, const daylight::Environment& environment,
                                     std::span<const light::MaskBlocker> bodies,
                                     const Job& job) const {
  std::vector<dvec3> out(count_, dvec3(0.0));
  if (count_ == 0) return out;
  const std::lock_guard lock(sky_->mutex);
  if (!sky_->open) {
    std::vector<vec3> positions;
    std::vector<vec3> normals;
    // Off the surface that a sensor may lie in, on the side that it looks to.
    for (std::size_t k = 0; k < count_ * orientations_; ++k) {
      const std::uint32_t slot = receivers_.slot_of[k];
      normals.push_back(receivers_.normal(slot));
      positions.push_back(receivers_.position(slot) + solver.scene().epsilon * normals.back());
    }
    const daylight::LookOptions fine{.coarse = 64, .levels = 3};
    daylight::OpenSky open(positions, normals, solver.scene().caster, solver.scene().panes.get(),
                           orientations_ == 1 ? fine : daylight::LookOptions{}, job);
    if (job.cancelled()) return out;
    sky_->open = std::move(open);
  }
  const std::vector<vec3> sky = sky_->open->illuminance(environment, job);
  for (std::size_t k = 0; k < sky.size(); ++k) {
    out[k / orientations_] += dvec3(sky[k]) / static_cast<double>(orientations_);
  }
  for (const daylight::Spot& spot : environment.spots()) {
    const auto lux = direct(solver, farDisc(spot, solver.scene().mesh->bounds()), bodies);
    for (std::size_t i = 0; i < count_; ++i) out[i] += lux[i] * spot.normal_illuminance;
  }
  return out;
}

std::vector<dvec3> Sensors::indirect(std::span<const vec4> source) const {
  std::vector<dvec3> out(count_, dvec3(0.0));
  if (lists_.lists.empty() || source.empty()) return out;
  std::vector<vec4> y(lists_.lists.size());
  parallelFor(y.size(), 64, [&](std::size_t begin, std::size_t end) {
    transfer::gather(lists_, begin, source, std::span(y).subspan(begin, end - begin));
  });
  for (std::size_t i = 0; i < count_; ++i) {
    for (std::size_t k = 0; k < orientations_; ++k) {
      const vec4& v = y[i * orientations_ + k];
      out[i] += dvec3(v.x, v.y, v.z);
    }
    out[i] /= static_cast<double>(orientations_);
  }
  return out;
}

}  // namespace soffit::relight

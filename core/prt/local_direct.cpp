// SPDX-License-Identifier: MIT
#include "core/prt/local_direct.h"

#include "core/base/parallel.h"
#include "core/light/light_cube.h"
#include "core/prt/direct_transfer.h"
#include "core/prt/directions.h"
#include "core/prt/shadow_pass.h"
#include "core/sh/sphere_samples.h"

#include <algorithm>
#include <array>
#include <optional>

namespace soffit::prt {
namespace {

/// m that a cube map's probe stands off its surface.
constexpr float kProbeLift = 0.05F;
/// Lines of sight per luminaire and cube: as many texels again as are lit.
constexpr int kLines = 1024;
/// Gradients serve receivers within this share of the distance to the light: error about its
/// square.
constexpr double kNear = 0.1;

Receivers slotsOf(const light::Receivers& points) {
  Receivers out;
  const std::size_t count = points.slotCount();
  for (std::size_t s = 0; s < count; ++s) {
    out.positions.push_back(points.position(s));
    out.normals.push_back(points.normal(s));
  }
  out.facing = out.normals;
  out.reflectance.assign(count, vec3(0.0F));
  out.areas.assign(count, 1.0F);
  return out;
}

}  // namespace

Result<std::shared_ptr<const LocalDirect>> LocalDirect::make(const Surfaces& surfaces,
                                                             const light::Receivers& receivers,
                                                             const LocalOptions& options,
                                                             const Job& job) {
  const std::shared_ptr<LocalDirect> made(new LocalDirect(receivers, options));
  const auto traced = options.method == LocalMethod::cubes ? made->traceCubes(surfaces, job)
                                                           : made->traceFlags(surfaces, job);
  if (!traced) return traced.error();
  return std::shared_ptr<const LocalDirect>(made);
}

Result<void> LocalDirect::traceFlags(const Surfaces& surfaces, const Job& job) {
  const Receivers slots = slotsOf(receivers_);
  const Directions directions(sh::hammersleySamples(static_cast<std::size_t>(options_.directions)),
                              options_.bands);
  auto pass = traceShadows(surfaces, slots, directions, job, options_.reach);
  if (!pass) return pass.error();
  rays_ = pass->rays;
  auto rows = shadowedTransfer(slots, directions, pass->flags, job);
  if (!rows) return rows.error();
  transfer_ = std::move(*rows);
  return {};
}

Result<void> LocalDirect::traceCubes(const Surfaces& surfaces, const Job& job) {
  transfer_ = unshadowedTransfer(slotsOf(receivers_), options_.bands);
  cubes_.resize(receivers_.clusters.size());
  parallelFor(cubes_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
      // The slot nearest to the middle: a place in the open, unlike the middle itself.
      const light::Receivers::Cluster& c = receivers_.clusters[i];
      const vec3 middle = 0.5F * (c.bounds.box.lo + c.bounds.box.hi);
      std::uint32_t best = c.begin;
      const auto away = [&](std::uint32_t s) {
        return glm::length(receivers_.position(s) - middle);
      };
      for (std::uint32_t s = c.begin; s < c.begin + c.used; ++s) {
        if (away(s) < away(best)) best = s;
      }
      const vec3 probe = receivers_.position(best) + kProbeLift * receivers_.normal(best);
      cubes_[i] = light::makeDepthCube(*surfaces.caster, dvec3(probe), options_.cube_side);
    }
  });
  if (job.cancelled()) return Error{"direct light", "cancelled", ""};
  rays_ = cubes_.size() * 6 * static_cast<std::uint64_t>(options_.cube_side) *
          static_cast<std::uint64_t>(options_.cube_side);
  return {};
}

float LocalDirect::illuminance(const sh::Coefficients& light, std::size_t slot) const {
  const std::span<const float> transfer = transfer_.vector(slot);
  double sum = 0.0;
  for (std::size_t i = 0; i < light.size(); ++i) sum += light[i] * static_cast<double>(transfer[i]);
  // Series that are cut off ring below zero; there is no such light.
  return static_cast<float>(std::max(sum, 0.0));
}

void LocalDirect::byHarmonics(const LuminaireLight& light, const light::Receivers::Cluster& cluster,
                              std::span<float> lux) const {
  const int bands = options_.bands;
  for (std::uint32_t group = cluster.begin; group < cluster.end;
       group += light::Receivers::kGroup) {
    const Box& box = receivers_.groups[group / light::Receivers::kGroup].box;
    const dvec3 middle(0.5F * (box.lo + box.hi));
    const double extent = 0.5 * glm::length(dvec3(box.hi - box.lo));
    std::optional<sh::CoefficientsWithGradient> around;
    if (extent < kNear * light.distance(middle)) around = light.around(middle, bands);
    for (std::uint32_t s = group; s < group + light::Receivers::kGroup; ++s) {
      const dvec3 p(receivers_.position(s));
      lux[s] = illuminance(around ? around->at(p - middle) : light.at(p, bands), s);
    }
  }
}

void LocalDirect::byCube(const light::Emitter& emitter, std::size_t i, std::span<float> lux) const {
  const light::Receivers::Cluster& c = receivers_.clusters[i];
  const light::LightCube cube =
      light::drawLights(cubes_[i], {&emitter, 1}, {.lines_of_sight = kLines});
  for (std::uint32_t s = c.begin; s < c.end; ++s) {
    lux[s] = 0.0F;
    if (cube.texels.empty()) continue;
    const sh::RgbCoefficients light =
        light::coefficientsAt(cube, {&emitter, 1}, dvec3(receivers_.position(s)), options_.bands);
    lux[s] = illuminance(light[1], s);  // grey light: one channel is all three
  }
}

void LocalDirect::illuminate(const light::Emitter& emitter, std::span<float> lux,
                             std::span<std::uint8_t> lit) const {
  light::Emitter plain = emitter;
  plain.gain = 1.0;
  plain.color = dvec3(1.0);
  const LuminaireLight light(plain);
  parallelFor(receivers_.clusters.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const light::Receivers::Cluster& c = receivers_.clusters[i];
      if (options_.method == LocalMethod::cubes) {
        byCube(plain, i, lux);
      } else {
        byHarmonics(light, c, lux);
      }
      const auto own = lux.subspan(c.begin, c.end - c.begin);
      lit[i] = std::any_of(own.begin(), own.end(), [](float e) { return e > 0.0F; }) ? 1 : 0;
    }
  });
}

std::size_t LocalDirect::bytes() const {
  std::size_t bytes = transfer_.bytes();
  for (const light::DepthCube& cube : cubes_) bytes += cube.distance.size() * sizeof(float);
  return bytes;
}

}  // namespace soffit::prt

// SPDX-License-Identifier: MIT
#include "core/relight/outdoors.h"

#include "core/base/parallel.h"
#include "core/relight/sky_cache.h"

#include <algorithm>
#include <cmath>

namespace soffit::relight {

light::Emitter farDisc(const daylight::Spot& spot, const Box& scene) {
  const double size = std::max(1.0, static_cast<double>(scene.diagonal()));
  const double distance = 5000.0 * size;
  // Wider than a few degrees a flat disc would be another shape from the side; light of that size
  // is no spot.
  const double radius = std::min(spot.radius, radians(5.0));
  light::Luminaire disc;
  disc.name = "sun";
  disc.shape = light::Disk{distance * std::tan(radius)};
  disc.position = (scene.empty() ? dvec3(0.0) : dvec3(scene.center())) + distance * spot.direction;
  // Emits to -z: z turns to the disc's direction.
  disc.rotation_deg = {0.0, degrees(std::acos(std::clamp(spot.direction.z, -1.0, 1.0))),
                       degrees(std::atan2(spot.direction.y, spot.direction.x))};
  // E = L pi sin^2 r on its axis, flux = pi L area.
  const double area = kPi * std::pow(distance * std::tan(radius), 2.0);
  disc.flux = area / std::pow(std::sin(radius), 2.0);
  return light::makeEmitter(disc).value();
}

namespace {

void addSpots(const Solver& solver, const daylight::Environment& environment,
              std::span<const light::MaskBlocker> bodies, Planes& direct, const Job& job) {
  for (const daylight::Spot& spot : environment.spots()) {
    if (job.cancelled()) return;
    Column one;
    solver.direct(farDisc(spot, solver.scene().mesh->bounds()), bodies, one);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto weight = static_cast<float>(spot.normal_illuminance[static_cast<int>(c)]);
      for (std::size_t s = 0; s < one.direct.size(); ++s) direct[c][s] += weight * one.direct[s];
    }
  }
}

}  // namespace

Column columnOf(std::vector<float> direct, const light::Receivers& receivers) {
  Column column;
  column.direct = std::move(direct);
  for (const light::Receivers::Cluster& c : receivers.clusters) {
    const auto begin = column.direct.begin();
    const bool lit = std::any_of(begin + c.begin, begin + c.end, [](float e) { return e > 0.0F; });
    column.lit.push_back(lit ? 1 : 0);
  }
  return column;
}

Outdoors outdoorLight(const Solver& solver,
                      const std::shared_ptr<const daylight::Environment>& environment,
                      std::span<const light::MaskBlocker> bodies, const Job& job) {
  Outdoors out;
  const auto e = solver.skyLight(environment, job);
  if (e == nullptr) return out;
  const transfer::Operators& op = solver.operators();
  const std::size_t slots = op.texels.slotCount();
  for (auto& plane : out.sky) plane.assign(slots, 0.0F);
  for (std::size_t s = 0; s < slots; ++s) {
    const vec3& shown = (*e)[op.fill_from[s]];
    for (std::size_t c = 0; c < 3; ++c) out.sky[c][s] = shown[static_cast<int>(c)];
  }
  Planes direct = out.sky;
  addSpots(solver, *environment, bodies, direct, job);
  if (job.cancelled()) return {};
  const std::size_t count = environment->grey() ? 1 : 3;
  for (std::size_t c = 0; c < count; ++c) {
    out.columns.push_back(columnOf(std::move(direct[c]), op.texels.receivers));
  }
  return out;
}

bool Solver::knowsSkyLight(const daylight::Environment* environment) const {
  const std::lock_guard lock(sky_->light_mutex);
  return sky_->lit_by.get() == environment;
}

std::shared_ptr<const std::vector<vec3>> Solver::skyLight(
    const std::shared_ptr<const daylight::Environment>& environment, const Job& job) const {
  const auto open = openSky(job);
  if (open == nullptr) return nullptr;
  const std::lock_guard lock(sky_->light_mutex);
  if (sky_->lit_by == environment) return sky_->light;
  auto light = std::make_shared<std::vector<vec3>>(open->illuminance(*environment, job));
  if (job.cancelled()) return nullptr;
  sky_->lit_by = environment;
  sky_->light = std::move(light);
  return sky_->light;
}

std::shared_ptr<const daylight::OpenSky> Solver::openSky(const Job& job) const {
  const std::lock_guard lock(sky_->mutex);
  if (sky_->open != nullptr) return sky_->open;
  const light::Receivers& receivers = operators_->texels.receivers;
  std::vector<vec3> positions(receivers.slotCount(), vec3(0.0F));
  std::vector<vec3> normals(receivers.slotCount(), vec3(0.0F));
  for (std::size_t s = 0; s < positions.size(); ++s) {
    positions[s] = receivers.position(s);
    // Slots that show another's light need no look of their own.
    if (operators_->fill_from[s] == s) normals[s] = receivers.normal(s);
  }
  if (!sky_->store.empty()) sky_->open = readSky(sky_->store, normals);
  if (sky_->open != nullptr) return sky_->open;
  daylight::LookOptions look;
  // Coarse light is there for seconds: a fifth of the rays will do.
  if (operators_->coarse) look.levels = 1;
  auto open = std::make_shared<const daylight::OpenSky>(positions, normals, scene_->caster,
                                                        scene_->panes.get(), look, job);
  if (job.cancelled()) return nullptr;
  if (!sky_->store.empty()) writeSky(sky_->store, *open);
  sky_->open = open;
  return open;
}

}  // namespace soffit::relight

// SPDX-License-Identifier: MIT
#include "core/design/compare.h"

#include "core/relight/sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace soffit::design {
namespace {

void addFlux(std::span<const light::Emitter> emitters, double area, LayoutFigures& figures) {
  for (const light::Emitter& e : emitters) {
    figures.installed_lm += e.flux;
    figures.emitted_lm += e.gain * e.flux;
    if (e.gain > 0.0) ++figures.luminaires_on;
  }
  if (area > 0.0) figures.lm_per_m2 = figures.emitted_lm / area;
}

void addPlanes(std::span<const scene::WorkPlane> planes,
               std::span<const relight::SensorLight> light, LayoutFigures& figures) {
  std::size_t at = 0;
  for (const scene::WorkPlane& plane : planes) {
    const auto count = static_cast<std::size_t>(plane.nu) * static_cast<std::size_t>(plane.nv);
    std::vector<double> lux;
    for (const relight::SensorLight& l : light.subspan(at, count)) {
      lux.push_back(glm::dot(l.direct + l.indirect, light::kLuminance));
    }
    at += count;
    figures.planes.push_back({plane.name, photometry::fieldMetrics(lux)});
  }
}

/// How many luminaires of `now` shed light that `before` did not compute at their place.
std::size_t newLights(std::span<const light::Luminaire> before,
                      std::span<const light::Luminaire> now,
                      std::span<const light::Emitter> old_emitters,
                      std::span<const light::Emitter> emitters) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < emitters.size(); ++i) {
    if (emitters[i].gain <= 0.0) continue;
    const bool same = i < old_emitters.size() && before[i].position == now[i].position &&
                      before[i].rotation_deg == now[i].rotation_deg &&
                      old_emitters[i].area == emitters[i].area &&
                      old_emitters[i].flux == emitters[i].flux && old_emitters[i].gain > 0.0;
    if (!same) ++count;
  }
  return count;
}

}  // namespace

std::vector<scene::Sensor> sensorsOfAll(std::span<const scene::WorkPlane> planes) {
  std::vector<scene::Sensor> sensors;
  for (const scene::WorkPlane& plane : planes) {
    const auto points = scene::sensorsOf(plane);
    sensors.insert(sensors.end(), points.begin(), points.end());
  }
  return sensors;
}

double areaOfAll(std::span<const scene::WorkPlane> planes) {
  double area = 0.0;
  for (const scene::WorkPlane& plane : planes) area += glm::length(glm::cross(plane.u, plane.v));
  return area;
}

LayoutFigures layoutFigures(std::string name, std::span<const light::Emitter> emitters,
                            std::span<const scene::WorkPlane> planes,
                            std::span<const relight::SensorLight> light) {
  LayoutFigures figures;
  figures.name = std::move(name);
  addFlux(emitters, areaOfAll(planes), figures);
  if (!light.empty()) addPlanes(planes, light, figures);
  return figures;
}

Result<std::vector<LayoutFigures>> compareLayouts(
    const std::shared_ptr<const relight::Solver>& solver, std::span<const scene::WorkPlane> planes,
    std::span<const LayoutCase> layouts, int sensor_rays, std::uint64_t seed, const Job& job,
    const LayoutVisitor& visit, std::shared_ptr<const daylight::Environment> environment) {
  const std::vector<scene::Sensor> sensors = sensorsOfAll(planes);
  std::optional<relight::Sensors> prepared;
  if (!sensors.empty()) {
    prepared.emplace(*solver, sensors, relight::Quantity::planar, sensor_rays, seed);
  }
  const auto lighting = std::make_shared<relight::Lighting>(solver);
  if (environment != nullptr) {
    const auto shone = lighting->setEnvironment(std::move(environment), job);
    if (!shone) return shone.error();
  }
  std::vector<LayoutFigures> out;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    job.report("comparing layouts", static_cast<double>(i) / static_cast<double>(layouts.size()));
    const std::vector<light::Emitter> old(lighting->emitters().begin(), lighting->emitters().end());
    const auto set = lighting->setLuminaires(layouts[i].luminaires, job);
    if (!set) {
      Error error = set.error();
      error.place = fmt::format("layouts.{}: {}", layouts[i].name, error.place);
      return error;
    }
    LayoutFigures figures =
        layoutFigures(layouts[i].name, lighting->emitters(), planes,
                      prepared ? lighting->read(*prepared) : std::vector<relight::SensorLight>());
    figures.lights_computed =
        newLights(i > 0 ? std::span<const light::Luminaire>(layouts[i - 1].luminaires)
                        : std::span<const light::Luminaire>(),
                  layouts[i].luminaires, old, lighting->emitters());
    if (visit) {
      const auto visited = visit(i, lighting);
      if (!visited) return visited.error();
    }
    out.push_back(std::move(figures));
  }
  return out;
}

}  // namespace soffit::design

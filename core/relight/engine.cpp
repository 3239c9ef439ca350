// SPDX-License-Identifier: MIT
#include "core/relight/engine.h"

#include "core/relight/sky_cache.h"
#include "core/transfer/bake_cache.h"
#include "core/transfer/cache_key.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>

namespace soffit::relight {
namespace {

struct Setting {
  double lowest;
  double highest;
  std::function<void(QualitySettings&, double)> set;
};

const std::map<std::string, Setting>& settings() {
  static const std::map<std::string, Setting> table = {
      {"texels",
       {100, 2e6, [](QualitySettings& q, double v) { q.bake.texels = static_cast<int>(v); }}},
      {"least_cell", {1e-4, 10, [](QualitySettings& q, double v) { q.bake.least_cell = v; }}},
      {"most_cell", {1e-4, 1e3, [](QualitySettings& q, double v) { q.bake.most_cell = v; }}},
      {"patch",
       {16, 256,
        [](QualitySettings& q, double v) { q.bake.patch = static_cast<std::uint32_t>(v); }}},
      {"node_rays",
       {2, 64, [](QualitySettings& q, double v) { q.bake.node_rays = static_cast<int>(v); }}},
      {"trainings",
       {4, 1024, [](QualitySettings& q, double v) { q.bake.trainings = static_cast<int>(v); }}},
      {"field_rays",
       {4, 128, [](QualitySettings& q, double v) { q.bake.field_rays = static_cast<int>(v); }}},
      {"list_rays",
       {4, 256, [](QualitySettings& q, double v) { q.bake.list_rays = static_cast<int>(v); }}},
      {"max_rank",
       {1, 128, [](QualitySettings& q, double v) { q.bake.max_rank = static_cast<int>(v); }}},
      {"lists", {0.01, 1, [](QualitySettings& q, double v) { q.bake.lists = v; }}},
      {"tolerance", {1e-6, 1, [](QualitySettings& q, double v) { q.bake.tolerance = v; }}},
      {"sensor_rays",
       {4, 1024, [](QualitySettings& q, double v) { q.sensor_rays = static_cast<int>(v); }}},
  };
  return table;
}

/// m. With cells of 44 cm a house of 6,000 m^2 of surfaces had black bands under its ceilings; with
/// four times the points a move takes 47 ms there.
constexpr double kMostCell = 0.2;

}  // namespace

Result<QualitySettings> qualitySettings(const scene::Quality& quality) {
  QualitySettings q;
  if (quality.preset == "draft") {
    q.bake.texels = 16000;
    q.bake.trainings = 48;
    q.bake.field_rays = 12;
    q.bake.list_rays = 24;
    q.bake.max_rank = 16;
    q.bake.tolerance = 0.1;
    q.sensor_rays = 32;
  } else if (quality.preset == "final") {
    q.bake.texels = 200000;
    q.bake.list_rays = 64;
    q.sensor_rays = 96;
  } else if (quality.preset != "interactive" && !quality.preset.empty()) {
    return Error{"quality", fmt::format("there is no quality \"{}\"", quality.preset),
                 "Choose draft, interactive or final."};
  }
  if (!quality.methods.empty()) {
    const auto& [name, value] = *quality.methods.begin();
    return Error{"quality." + name, fmt::format("expected a number, found \"{}\"", value),
                 "Give a number, or leave the setting out."};
  }
  // A number of texels that somebody asked for is what they get.
  if (!quality.settings.contains("texels")) q.bake.most_cell = kMostCell;
  for (const auto& [name, value] : quality.settings) {
    const auto found = settings().find(name);
    if (found == settings().end()) {
      std::string known;
      for (const auto& [key, setting] : settings()) known += (known.empty() ? "" : ", ") + key;
      return Error{"quality." + name, "there is no such setting", "Settings are: " + known + "."};
    }
    const Setting& s = found->second;
    if (!std::isfinite(value) || value < s.lowest || value > s.highest) {
      return Error{"quality." + name,
                   fmt::format("expected {} to {}, found {}", s.lowest, s.highest, value),
                   "Choose a value in that range, or leave the setting out."};
    }
    s.set(q, value);
  }
  return q;
}

std::shared_ptr<const transfer::StaticScene> makeStaticScene(const scene::Scene& scene) {
  std::vector<vec3> inside;
  const dvec3 origin = scene.mesh->origin;
  for (const light::Luminaire& l : scene.luminaires) inside.emplace_back(l.position - origin);
  for (const scene::Camera& c : scene.cameras) inside.emplace_back(c.position - origin);
  for (const scene::WorkPlane& plane : scene.work_planes) {
    inside.emplace_back(plane.origin + 0.5 * (plane.u + plane.v) - origin);
  }
  return transfer::makeStaticScene(scene.mesh, inside,
                                   daylight::Panes::make(*scene.mesh, scene.materials));
}

Result<std::shared_ptr<const Solver>> makeSolver(const scene::Scene& scene,
                                                 const QualitySettings& quality, bool use_cache,
                                                 const Job& job, EngineReport& report,
                                                 const CoarseSolver& coarse) {
  job.report("preparing geometry", 0.0);
  const auto static_scene = makeStaticScene(scene);
  transfer::CoarseResult on_coarse;
  if (coarse) {
    on_coarse = [&](const std::shared_ptr<const transfer::Operators>& found) {
      if (!job.cancelled())
        coarse(std::make_shared<const Solver>(static_scene, found, scene.materials));
    };
  }
  auto operators = transfer::bakeOrLoad(*static_scene, quality.bake, use_cache, job, on_coarse,
                                        &report.bake, report.cached, report.messages);
  if (!operators) return operators.error();
  report.bytes = (*operators)->bytes();
  auto solver = std::make_shared<Solver>(static_scene, *operators, scene.materials);
  // The name is only asked for where there may be a sky: the key reads all of the mesh.
  if (use_cache && scene.environment && !scene.mesh->triangles.empty()) {
    solver->keepSky(skyPath(transfer::cacheKey(*static_scene, quality.bake)));
  }
  return std::shared_ptr<const Solver>(std::move(solver));
}

}  // namespace soffit::relight

// SPDX-License-Identifier: MIT
#include "core/relight/engine.h"

#include "core/relight/sky_cache.h"
#include "core/transfer/bake_cache.h"
#include "core/transfer/cache_key.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

namespace soffit::relight {
namespace {

/// A number among the settings: where it lies, its range, what sets it. of_method: for others than
/// the exact direct light.
struct Setting {
  const char* name;
  double lowest;
  double highest;
  std::variant<int*, double*, float*, std::uint32_t*> value;
  bool of_method = false;
};

std::vector<Setting> settingsOf(QualitySettings& q, prt::LocalOptions& local) {
  transfer::BakeSettings& b = q.bake;
  return {{"texels", 100, 2e6, &b.texels},
          {"least_cell", 1e-4, 10, &b.least_cell},
          {"most_cell", 1e-4, 1e3, &b.most_cell},
          {"patch", 16, 256, &b.patch},
          {"node_rays", 2, 64, &b.node_rays},
          {"trainings", 4, 1024, &b.trainings},
          {"field_rays", 4, 128, &b.field_rays},
          {"list_rays", 4, 256, &b.list_rays},
          {"max_rank", 1, 128, &b.max_rank},
          {"lists", 0.01, 1, &b.lists},
          {"tolerance", 1e-6, 1, &b.tolerance},
          {"sweeps", 0, 16, &q.sweeps},
          {"sensor_rays", 4, 1024, &q.sensor_rays},
          {"bands", 2, sh::kMaxBands, &local.bands, true},
          {"directions", 16, 65536, &local.directions, true},
          {"reach", 1e-3, 1e6, &local.reach, true},
          {"cube_side", 4, 128, &local.cube_side, true}};
}

void set(const Setting& setting, double value) {
  std::visit([&](auto* v) { *v = static_cast<std::remove_pointer_t<decltype(v)>>(value); },
             setting.value);
}

Result<void> readMethods(const scene::Quality& quality, QualitySettings& q) {
  for (const auto& [name, value] : quality.methods) {
    if (name != "direct") {
      return Error{"quality." + name, fmt::format("expected a number, found \"{}\"", value),
                   "Give a number, or leave the setting out. Names belong to \"direct\" alone."};
    }
    if (value == kDirectMethods[0]) continue;
    if (value == kDirectMethods[1]) {
      q.local.emplace();
    } else if (value == kDirectMethods[2]) {
      q.local = prt::LocalOptions{.method = prt::LocalMethod::cubes};
    } else {
      return Error{"quality.direct", fmt::format("there is no method \"{}\"", value),
                   fmt::format("Choose one of: {}.", fmt::join(kDirectMethods, ", "))};
    }
  }
  return {};
}

/// m. With cells of 44 cm a house of 6,000 m^2 of surfaces had black bands under its ceilings; with
/// four times the points a move takes 47 ms there.
constexpr double kMostCell = 0.2;
constexpr double kMostDraftCell = 0.4;

/// Places that are known to lie in rooms.
std::vector<vec3> insideOf(const scene::Scene& scene) {
  std::vector<vec3> inside;
  const dvec3 origin = scene.mesh->origin;
  for (const light::Luminaire& l : scene.luminaires) inside.emplace_back(l.position - origin);
  for (const scene::Camera& c : scene.cameras) inside.emplace_back(c.position - origin);
  for (const scene::WorkPlane& plane : scene.work_planes) {
    inside.emplace_back(plane.origin + 0.5 * (plane.u + plane.v) - origin);
  }
  return inside;
}

}  // namespace

Result<QualitySettings> qualitySettings(const scene::Quality& quality) {
  QualitySettings q;
  if (quality.preset == "draft") {
    q.bake.texels = 16000;
    q.bake.trainings = 48;
    q.bake.field_rays = 12;
    q.bake.list_rays = 24;
    q.bake.lists = 0.22;
    q.sweeps = 0;
    q.bake.max_rank = 16;
    q.bake.tolerance = 0.1;
    q.sensor_rays = 32;
  } else if (quality.preset == "final") {
    q.bake.texels = 200000;
    q.bake.list_rays = 64;
    q.bake.lists = 0.22;
    q.sensor_rays = 96;
  } else if (quality.preset != "interactive" && !quality.preset.empty()) {
    return Error{"quality", fmt::format("there is no quality \"{}\"", quality.preset),
                 "Choose draft, interactive or final."};
  }
  if (const auto read = readMethods(quality, q); !read) return read.error();
  // A number of texels that somebody asked for is what they get.
  if (!quality.settings.contains("texels")) {
    q.bake.most_cell = quality.preset == "draft" ? kMostDraftCell : kMostCell;
  }
  prt::LocalOptions unused;
  const std::vector<Setting> known = settingsOf(q, q.local ? *q.local : unused);
  for (const auto& [name, value] : quality.settings) {
    const auto found = std::find_if(known.begin(), known.end(), [&wanted = name](const Setting& s) {
      return wanted == s.name;
    });
    if (found == known.end()) {
      std::string names = "direct";
      for (const Setting& s : known) names += fmt::format(", {}", s.name);
      return Error{"quality." + name, "there is no such setting", "Settings are: " + names + "."};
    }
    if (!std::isfinite(value) || value < found->lowest || value > found->highest) {
      return Error{"quality." + name,
                   fmt::format("expected {} to {}, found {}", found->lowest, found->highest, value),
                   "Choose a value in that range, or leave the setting out."};
    }
    set(*found, value);
  }
  return q;
}

Result<std::vector<SettingInfo>> listSettings(const scene::Quality& quality) {
  auto q = qualitySettings(quality);
  if (!q) return q.error();
  prt::LocalOptions usual;
  std::vector<SettingInfo> list;
  for (const Setting& s : settingsOf(*q, q->local ? *q->local : usual)) {
    const bool whole =
        std::holds_alternative<int*>(s.value) || std::holds_alternative<std::uint32_t*>(s.value);
    const double value = std::visit([](const auto* v) { return static_cast<double>(*v); }, s.value);
    list.push_back({s.name, s.lowest, s.highest, value, whole, s.of_method});
  }
  return list;
}

std::shared_ptr<const transfer::StaticScene> makeStaticScene(const scene::Scene& scene) {
  return transfer::makeStaticScene(scene.mesh, insideOf(scene),
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
      if (job.cancelled()) return;
      auto early = std::make_shared<Solver>(static_scene, found, scene.materials);
      early->useSweeps(quality.sweeps);
      coarse(std::move(early));
    };
  }
  auto operators = transfer::bakeOrLoad(*static_scene, quality.bake, use_cache, job, on_coarse,
                                        &report.bake, report.cached, report.messages);
  if (!operators) return operators.error();
  report.bytes = (*operators)->bytes();
  auto solver = std::make_shared<Solver>(static_scene, *operators, scene.materials);
  solver->useSweeps(quality.sweeps);
  if (quality.local) {
    job.report("shadows for direct light", 0.0);
    const auto surfaces = prt::makeSurfaces(scene.mesh, scene.materials, insideOf(scene));
    const auto method =
        prt::LocalDirect::make(*surfaces, (*operators)->texels.receivers, *quality.local, job);
    if (!method) return method.error();
    report.bytes += (*method)->bytes();
    solver->useDirect(*method);
  }
  // The name is only asked for where there may be a sky: the key reads all of the mesh.
  if (use_cache && scene.environment && !scene.mesh->triangles.empty()) {
    solver->keepSky(skyPath(transfer::cacheKey(*static_scene, quality.bake)));
  }
  return std::shared_ptr<const Solver>(std::move(solver));
}

}  // namespace soffit::relight

// SPDX-License-Identifier: MIT
#include "app/cli/engine.h"

#include "core/io/project/csv.h"
#include "core/render/engine_light.h"

#include <fmt/format.h>

namespace soffit::cli {

Result<Engine> makeEngine(const io::Project& project, const CommonOptions& options, bool light,
                          const Job& job, Session& session, const relight::CoarseSolver& coarse) {
  Engine engine;
  auto quality = relight::qualitySettings(project.scene.quality);
  if (!quality) {
    Error error = quality.error();
    error.place = fmt::format("{}: {}", project.path.string(), error.place);
    return error;
  }
  engine.quality = *quality;
  engine.quality.bake.seed = options.seed;
  auto solver = relight::makeSolver(project.scene, engine.quality, !options.no_cache, job,
                                    engine.report, coarse);
  if (!solver) return solver.error();
  engine.solver = *solver;
  session.warnings.insert(session.warnings.end(), engine.report.messages.begin(),
                          engine.report.messages.end());
  if (light) {
    engine.lighting = std::make_shared<relight::Lighting>(engine.solver);
    const auto set = engine.lighting->setLuminaires(project.scene.luminaires, job);
    if (!set) return set.error();
    if (project.scene.environment) {
      const auto shone = engine.lighting->setEnvironment(
          std::make_shared<daylight::Environment>(*project.scene.environment), job);
      if (!shone) return shone.error();
    }
  }
  return engine;
}

MakePictureLight pictureLight(Session& session) {
  return [&session](const io::Project& project, const CommonOptions& options,
                    const Job& job) -> Result<PictureLight> {
    auto engine = makeEngine(project, options, true, job, session);
    if (!engine) return engine.error();
    // The caster lives in the engine's static scene: share its ownership.
    std::shared_ptr<const relight::Lighting> lighting = engine->lighting;
    std::shared_ptr<const geometry::RayCaster> caster(lighting, &lighting->solver().scene().caster);
    const auto best = [lighting](
                          const render::ViewScene& scene,
                          const Job& at) -> Result<std::shared_ptr<const render::Illumination>> {
      auto light = render::EngineLight::withThrownLight(lighting, scene, {}, at);
      if (!light) return light.error();
      return std::shared_ptr<const render::Illumination>(std::move(*light));
    };
    return PictureLight{std::make_shared<const render::EngineLight>(lighting), caster, best};
  };
}

Result<std::vector<scene::Sensor>> sensorsFor(const io::Project& project, const std::string& file) {
  if (!file.empty()) return io::readSensors(file);
  std::vector<scene::Sensor> sensors;
  for (const scene::WorkPlane& plane : project.scene.work_planes) {
    const auto points = scene::sensorsOf(plane);
    sensors.insert(sensors.end(), points.begin(), points.end());
  }
  if (sensors.empty()) {
    return Error{project.path.filename().string(), "the project has no work planes",
                 "Name sensors with --sensors PTS.csv, or add work_planes to the project."};
  }
  return sensors;
}

double lux(const dvec3& rgb) {
  return glm::dot(rgb, light::kLuminance);
}

}  // namespace soffit::cli

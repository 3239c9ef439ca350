// SPDX-License-Identifier: MIT
#include "app/cli/bench_glossy_command.h"

#include "app/cli/bench_frame.h"
#include "app/cli/engine.h"
#include "app/cli/picture_setup.h"
#include "core/design/glossy_bench.h"
#include "core/design/glossy_pictures.h"
#include "core/io/project/json.h"
#include "core/render/engine_light.h"
#include "core/render/live_probes.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

namespace soffit::cli {
namespace {

struct BenchGlossyArguments {
  CommonOptions common;
  std::string camera, size = "1280x800";
  design::GlossyPictureOptions pictures;
  design::GlossyBenchOptions methods;
};

std::string tableOf(const std::vector<design::GlossyBenchRow>& rows) {
  std::string text = fmt::format("{:<11} {:<62} {:>5} {:>6} {:>9} {:>9} {:>9}\n", "task", "method",
                                 "bands", "items", "ms", "MB", "RMS error");
  for (const design::GlossyBenchRow& r : rows) {
    text += fmt::format("{:<11} {:<62} {:>5} {:>6} {:>9.3f} {:>9.2f} {:>9.1e}\n", r.task, r.method,
                        r.bands, r.items, r.ms, static_cast<double>(r.bytes) / 1e6, r.rms_error);
  }
  return text;
}

std::string tableOf(const std::vector<design::GlossyPictureRow>& rows) {
  std::string text =
      fmt::format("{:<20} {:<28} {:<28} {:>6} {:>8} {:>7} {:>6} {:>7} {:>7} {:>7}\n", "camera",
                  "method", "part", "pixels", "cd/m2", "RMS %", "+-", "bias %", "noise %", "s");
  for (const design::GlossyPictureRow& r : rows) {
    text += fmt::format(
        "{:<20} {:<28} {:<28} {:>6} {:>8.2f} {:>7.2f} {:>6.2f} {:>7.2f} {:>7.2f} {:>7.2f}\n",
        r.camera, r.method, r.part, r.pixels, r.mean, 100 * r.rms, 100 * r.rms_error, 100 * r.bias,
        100 * r.noise, r.seconds);
  }
  return text;
}

io::Json jsonOf(const std::vector<design::GlossyBenchRow>& rows,
                const std::vector<design::GlossyPictureRow>& pictures) {
  io::JsonArray list;
  for (const design::GlossyBenchRow& r : rows) {
    list.push_back(io::Json::object({{"task", r.task},
                                     {"method", r.method},
                                     {"bands", r.bands},
                                     {"items", r.items},
                                     {"ms", r.ms},
                                     {"bytes", r.bytes},
                                     {"rms_error", r.rms_error}}));
  }
  io::JsonArray seen;
  for (const design::GlossyPictureRow& r : pictures) {
    seen.push_back(io::Json::object({{"camera", r.camera},
                                     {"method", r.method},
                                     {"part", r.part},
                                     {"pixels", r.pixels},
                                     {"mean", r.mean},
                                     {"rms", r.rms},
                                     {"rms_error", r.rms_error},
                                     {"bias", r.bias},
                                     {"noise", r.noise},
                                     {"seconds", r.seconds}}));
  }
  return io::Json::object({{"rows", list}, {"pictures", seen}});
}

/// The pictures of one camera, or of all, of the project's shown layout.
Result<design::GlossyPictures> picturesOf(BenchGlossyArguments& arguments, Session& session,
                                          ProgressBar& progress) {
  const auto size = parseSize(arguments.size);
  if (!size) return size.error();
  std::tie(arguments.pictures.width, arguments.pictures.height) = *size;
  arguments.pictures.seed = arguments.common.seed;
  const auto project = loadForCommand(arguments.common, session, &progress);
  if (!project) return project.error();
  const Job job = session.job(progress);
  std::vector<scene::Camera> cameras = project->scene.cameras;
  if (!arguments.camera.empty() || cameras.empty()) {
    const auto chosen = chooseCamera(project->scene, arguments.camera);
    if (!chosen) return chosen.error();
    cameras = {*chosen};
  }
  const auto engine = makeEngine(*project, arguments.common, true, job, session);
  if (!engine) return engine.error();
  const std::shared_ptr<const relight::Lighting> lighting = engine->lighting;
  const std::shared_ptr<const geometry::RayCaster> caster(lighting,
                                                          &lighting->solver().scene().caster);
  // The path tracer knows flat triangles alone: so do the pictures here.
  scene::Scene faceted = project->scene;
  auto mesh = std::make_shared<geometry::Mesh>(*faceted.mesh);
  mesh->normals.clear();
  faceted.mesh = mesh;
  for (scene::Material& material : faceted.materials) material.normal_image = nullptr;
  const auto view = makeViewScene(faceted, caster);
  if (!view) return view.error();
  const auto reference =
      reference::ReferenceScene::make(project->scene, project->scene.luminaires, caster);
  if (!reference) return reference.error();
  const render::EngineLight light(lighting);
  const auto best = render::EngineLight::withThrownLight(lighting, **view, {}, job);
  if (!best) return best.error();
  const auto probes = render::LiveProbes::make(**view, lighting->solver().operators().texels, job);
  const auto live = probes == nullptr
                        ? nullptr
                        : probes->light(lighting->total(),
                                        render::LampMaker().lampsOf(lighting->emitters(), *caster,
                                                                    probes->places()),
                                        lighting->environment());
  design::GlossyPictures all;
  for (const scene::Camera& camera : cameras) {
    const auto found = design::measureGlossyPictures(**view, {light, **best, live.get()},
                                                     *reference, camera, arguments.pictures, job);
    if (!found) return found.error();
    all.rows.insert(all.rows.end(), found->rows.begin(), found->rows.end());
    all.pixels += found->pixels;
  }
  return all;
}

Result<void> runBenchGlossy(BenchGlossyArguments arguments, Session& session) {
  return runBenchFrame(
      arguments.common, "glossy.csv", [&](ProgressBar& progress) -> Result<BenchFindings> {
        design::GlossyPictures pictures;
        if (!arguments.common.project.empty()) {
          auto found = picturesOf(arguments, session, progress);
          if (!found) return found.error();
          pictures = std::move(*found);
        }
        arguments.methods.seed = arguments.common.seed;
        const auto rows = design::measureGlossy(arguments.methods, session.job(progress));
        if (!rows) return rows.error();
        BenchFindings found{tableOf(*rows),
                            jsonOf(*rows, pictures.rows),
                            {{"glossy.csv", design::formatGlossyBenchRows(*rows)}}};
        if (!pictures.rows.empty()) {
          found.table = tableOf(pictures.rows) + "\n" + found.table;
          found.files.push_back(
              {"glossy_pictures.csv", design::formatGlossyPictureRows(pictures.rows)});
          found.files.push_back({"glossy_pixels.csv", pictures.pixels});
        }
        return found;
      });
}

}  // namespace

void addBenchGlossyCommand(CLI::App& bench, Session& session) {
  CLI::App* command = bench.add_subcommand(
      "glossy",
      "Reflections: time, memory and error of each method; pictures of a project by each");
  auto arguments = std::make_shared<BenchGlossyArguments>();
  command->add_option("P", arguments->common.project,
                      "Project whose pictures are compared with the path tracer; none without");
  addLayoutOption(*command, arguments->common);
  addSetOption(*command, arguments->common);
  addBenchOptions(*command, arguments->common,
                  "glossy.csv, glossy_pictures.csv and glossy_pixels.csv");
  command->add_option("--camera", arguments->camera, "One camera instead of all");
  command->add_option("--size", arguments->size, "Pixels of the pictures")->type_name("WxH");
  command
      ->add_option("--stride", arguments->pictures.stride,
                   "Every so many pixels both ways are compared")
      ->check(CLI::Range(1, 1000));
  command->add_option("--paths", arguments->pictures.paths, "Half the path tracer's per pixel")
      ->check(CLI::Range(1, 1 << 24));
  command
      ->add_option("--receivers", arguments->methods.receivers,
                   "Receivers over which the methods are measured")
      ->check(CLI::Range(1, 1000000));
  command->callback([&session, arguments] {
    session.run = [arguments, &session] { return runBenchGlossy(*arguments, session); };
  });
}

}  // namespace soffit::cli

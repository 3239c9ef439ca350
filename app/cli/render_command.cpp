// SPDX-License-Identifier: MIT
#include "app/cli/render_command.h"

#include "app/cli/output.h"
#include "app/cli/picture_file.h"
#include "app/cli/picture_setup.h"
#include "app/cli/progress_bar.h"
#include "core/color/display_transform.h"
#include "core/color/exposure.h"
#include "core/io/image/write_image.h"
#include "core/render/picture.h"
#include "core/render/quick_reflections.h"
#include "core/render/view_renderer.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace soffit::cli {
namespace {

struct RenderArguments {
  CommonOptions common;
  std::string camera;
  std::string size = "1280x800";
  int samples = 4;
  render::Reflections glossy = render::Reflections::automatic;
  std::string exposure;       ///< EV or "auto"; empty: the project's
  std::string view;           ///< empty: the project's
  std::string white_balance;  ///< kelvin or "auto"; empty: the project's
  std::vector<double> range;
  bool logarithmic = false;
  std::string title;
  std::optional<double> tone_key;
  std::optional<double> tone_white;
  std::optional<double> bloom;
  std::optional<double> bloom_strength;
};

Result<render::PictureOptions> pictureOptions(const RenderArguments& arguments,
                                              const scene::Scene& scene) {
  const scene::View& view = scene.view;
  render::PictureOptions picture;
  picture.display.display = view.ocio_display;
  picture.display.view = arguments.view.empty() ? view.ocio_view : arguments.view;
  picture.display.look = view.ocio_look;
  finishAsProject(view, picture);
  const auto white = parseWhiteBalance(arguments.white_balance, scene);
  if (!white) return white.error();
  picture.display.white_balance = *white;
  if (arguments.tone_key) picture.tone.key = *arguments.tone_key;
  if (arguments.tone_white) picture.tone.white = *arguments.tone_white;
  if (arguments.bloom) picture.bloom.threshold = *arguments.bloom;
  if (arguments.bloom_strength) picture.bloom.strength = *arguments.bloom_strength;
  picture.title = arguments.title;
  if (arguments.range.size() == 2) {
    picture.range =
        color::FalseColorRange{arguments.range[0], arguments.range[1], arguments.logarithmic};
    const auto valid = picture.range->check();
    if (!valid) return valid.error();
  }
  // A view that does not exist is found before the light is computed.
  const auto transform = color::DisplayTransform::create(picture.display);
  if (!transform) return transform.error();
  return picture;
}

bool isDark(const render::Film& film) {
  return std::all_of(film.radiance.begin(), film.radiance.end(),
                     [](const auto& v) { return v == std::decay_t<decltype(v)>(0.0F); });
}

/// Whether surfaces are lit by what specular ones throw on them: where reflections are traced.
bool followsReflections(const render::RenderOptions& options) {
  return options.quantity == render::Quantity::luminance &&
         render::settled(options.reflections, options.quick) == render::Reflections::rays;
}

Result<void> runRender(const RenderArguments& arguments, Session& session,
                       const MakePictureLight& make) {
  const std::string& output = arguments.common.output;
  if (auto known = io::checkImagePath(output); !known) return known;
  if (auto writable = checkResultFile(output); !writable) return writable;
  const auto size = parseSize(arguments.size);
  if (!size) return size.error();
  ProgressBar progress;
  const auto project = loadForCommand(arguments.common, session, &progress);
  if (!project) return project.error();
  const scene::Scene& scene = project->scene;
  const auto camera = chooseCamera(scene, arguments.camera);
  if (!camera) return camera.error();
  const auto exposure = parseExposure(arguments.exposure, scene.view.exposure);
  if (!exposure) return exposure.error();
  auto picture = pictureOptions(arguments, scene);
  if (!picture) return picture.error();

  render::RenderOptions options;
  options.width = size->first;
  options.height = size->second;
  options.samples = arguments.samples;
  options.seed = arguments.common.seed;
  options.reflections = arguments.glossy;
  if (picture->display.view == color::kFalseColorView)
    options.quantity = render::Quantity::illuminance;
  if (!io::isSceneLinear(output)) {
    // A few stops above white, where the views' shoulders have flattened out.
    options.edge_white = 4.0F / color::exposureScale(exposure->value_or(scene.view.exposure));
  }
  const Job job = session.job(progress);
  const auto light = make(*project, arguments.common, job);
  if (!light) return light.error();
  const auto view_scene = makeViewScene(scene, light->caster);
  if (!view_scene) return view_scene.error();
  std::shared_ptr<const render::Illumination> illumination = light->illumination;
  if (light->best && (*view_scene)->hasSpecular() && followsReflections(options)) {
    auto best = light->best(**view_scene, job);
    if (!best) return best.error();
    illumination = std::move(*best);
  }
  const auto film = render::renderView(**view_scene, *camera, *illumination, options, job);
  if (!film) return film.error();
  picture->exposure_ev = exposure->has_value() ? **exposure : color::autoExposure(film->radiance);
  progress.clear();
  if (isDark(*film)) {
    session.warnings.push_back(fmt::format(
        "the picture is black: the camera \"{}\" stands inside of something or looks away from the "
        "model, or no luminaire is on{}",
        camera->name, project->layout.empty() ? "" : " in the layout " + project->layout));
  }
  return writePicture(output, *film, *picture,
                      {.project = scene.name.empty() ? project->path.stem().string() : scene.name,
                       .layout = project->layout,
                       .camera = camera->name});
}

}  // namespace

void addRenderCommand(CLI::App& app, Session& session, MakePictureLight make) {
  CLI::App* command = app.add_subcommand(
      "render", "Make a picture: tone-mapped .png/.jpg/.tif or scene-linear .exr/.hdr");
  auto arguments = std::make_shared<RenderArguments>();
  addProjectArgument(*command, arguments->common);
  addOutputOption(*command, arguments->common, "The picture to write");
  command->get_option("--output")->required();
  addLayoutOption(*command, arguments->common);
  addSetOption(*command, arguments->common);
  addComputeOptions(*command, arguments->common);
  command->add_option("--camera", arguments->camera, "Camera by name; without it: the first");
  command->add_option("--size", arguments->size, "Pixels, WxH")->capture_default_str();
  command->add_option("--samples", arguments->samples, "Samples per pixel")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  command
      ->add_option(
          "--glossy", arguments->glossy,
          "Reflections of rough specular surfaces: automatic (rays), none, maps (cube maps "
          "at probes), harmonics (spherical harmonics, maps for sharper lobes), or rays, "
          "which also light other surfaces by reflections")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, render::Reflections>{{"automatic", render::Reflections::automatic},
                                                     {"none", render::Reflections::none},
                                                     {"maps", render::Reflections::maps},
                                                     {"harmonics", render::Reflections::harmonics},
                                                     {"rays", render::Reflections::rays}}))
      ->option_text("METHOD");
  command->add_option("--exposure", arguments->exposure,
                      "Stops (EV), or auto; without it: the project's");
  command->add_option(
      "--ocio-view", arguments->view,
      "View: Filmic, ACES, sRGB, Reinhard, \"Reinhard 2002\", Tumblin-Rushmeier, \"False colour\"; "
      "without it: the project's");
  command->add_option("--white-balance", arguments->white_balance,
                      "Colour temperature that is shown as white, in kelvin; auto: that of the "
                      "luminaires, 0: daylight; without it: the project's");
  command
      ->add_option(
          "--tone-key", arguments->tone_key,
          "Reinhard 2002: what the average becomes, 0.18 is mid grey; 0: as the picture asks")
      ->check(CLI::Range(0.0, 100.0));
  command
      ->add_option(
          "--tone-white", arguments->tone_white,
          "Reinhard 2002: the smallest luminance that becomes white, in units of the key; 0: as "
          "the picture asks")
      ->check(CLI::Range(0.0, 1e6));
  command
      ->add_option("--bloom", arguments->bloom,
                   "Spread what is brighter than so many cd/m2; 0: none; without it: the project's")
      ->check(CLI::Range(0.0, 1e9));
  command->add_option("--bloom-strength", arguments->bloom_strength, "Share that is spread, 0 to 1")
      ->check(CLI::Range(0.0, 1.0));
  command
      ->add_option("--range", arguments->range,
                   "False colour: MIN,MAX in lux; without it: what fits")
      ->delimiter(',')
      ->expected(2);
  command->add_flag("--log", arguments->logarithmic,
                    "False colour: a logarithmic scale, with --range");
  command->add_option("--title", arguments->title, "Text printed into the picture");
  command->callback([&session, arguments, make = std::move(make)] {
    session.run = [arguments, &session, make] { return runRender(*arguments, session, make); };
  });
}

}  // namespace soffit::cli

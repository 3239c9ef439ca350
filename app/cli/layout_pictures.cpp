// SPDX-License-Identifier: MIT
#include "app/cli/layout_pictures.h"

#include "app/cli/picture_file.h"
#include "app/cli/picture_setup.h"
#include "core/color/exposure.h"
#include "core/io/image/file_name.h"
#include "core/io/image/write_image.h"
#include "core/render/difference_picture.h"
#include "core/render/engine_light.h"
#include "core/render/view_renderer.h"

#include <fmt/format.h>

#include <algorithm>

namespace soffit::cli {

LayoutPictures::LayoutPictures(std::string folder, LayoutPictureOptions options)
    : folder_(std::move(folder)), options_(std::move(options)) {}

Result<void> LayoutPictures::prepare(const scene::Scene& scene) {
  if (options_.camera == "all" && !scene.cameras.empty()) {
    cameras_ = scene.cameras;
  } else {
    const auto camera = chooseCamera(scene, options_.camera == "all" ? "" : options_.camera);
    if (!camera) return camera.error();
    cameras_ = {*camera};
  }
  const auto exposure = parseExposure(options_.exposure, scene.view.exposure);
  if (!exposure) return exposure.error();
  auto_exposure_ = !exposure->has_value();
  picture_.exposure_ev = exposure->value_or(scene.view.exposure);
  picture_.display.display = scene.view.ocio_display;
  picture_.display.view = options_.view.empty() ? scene.view.ocio_view : options_.view;
  picture_.display.look = scene.view.ocio_look;
  finishAsProject(scene.view, picture_);
  const auto transform = color::DisplayTransform::create(picture_.display);
  if (!transform) return transform.error();
  return {};
}

Result<void> LayoutPictures::take(const io::Project& variant, const std::string& layout,
                                  const std::shared_ptr<const relight::Lighting>& lighting,
                                  const Job& job) {
  const auto view_scene = makeViewScene(
      variant.scene,
      std::shared_ptr<const geometry::RayCaster>(lighting, &lighting->solver().scene().caster));
  if (!view_scene) return view_scene.error();
  render::RenderOptions options;
  options.width = options_.width;
  options.height = options_.height;
  options.samples = options_.samples;
  if (picture_.display.view == color::kFalseColorView) {
    options.quantity = render::Quantity::illuminance;
  }
  options.edge_white = 4.0F / color::exposureScale(picture_.exposure_ev);
  std::shared_ptr<const render::EngineLight> light;
  if (options.quantity == render::Quantity::luminance) {
    auto thrown = render::EngineLight::withThrownLight(lighting, **view_scene, {}, job);
    if (!thrown) return thrown.error();
    light = std::move(*thrown);
  } else {
    light = std::make_shared<const render::EngineLight>(lighting);
  }
  for (std::size_t c = 0; c < cameras_.size(); ++c) {
    auto film = render::renderView(**view_scene, cameras_[c], *light, options, job);
    if (!film) return film.error();
    if (auto_exposure_) {
      picture_.exposure_ev = color::autoExposure(film->radiance);
      auto_exposure_ = false;
    }
    if (!picture_.adapted_to) picture_.adapted_to = color::pictureLuminance(film->radiance);
    // One scale for all layouts in false colour, too.
    if (!picture_.range) picture_.range = render::fittingRange(*film);
    auto written = write(variant, layout, c, *film);
    if (!written) return written;
    if (first_.size() < cameras_.size()) {
      first_layout_ = layout;
      first_.push_back(std::move(*film));
    }
  }
  return {};
}

Result<void> LayoutPictures::write(const io::Project& variant, const std::string& layout,
                                   std::size_t camera, const render::Film& film) {
  const std::string suffix =
      cameras_.size() > 1 ? ", " + io::fileNameOf(cameras_[camera].name) : std::string();
  const std::string project =
      variant.scene.name.empty() ? variant.path.stem().string() : variant.scene.name;
  const auto path = folder_ / (io::fileNameOf(layout) + suffix + ".png");
  auto written =
      writePicture(path, film, picture_,
                   {.project = project, .layout = layout, .camera = cameras_[camera].name});
  if (!written) return written;
  files_.push_back(path.string());
  if (first_.size() < cameras_.size()) return {};

  // Layouts are compared on one scale: the first difference sets it.
  if (ranges_.size() <= camera) {
    ranges_.push_back(options_.range_lux.value_or(render::fittingDifference(first_[camera], film)));
  }
  const std::string title = fmt::format("{} \u2212 {}", layout, first_layout_);
  const auto difference = render::differencePicture(first_[camera], film,
                                                    {.range_lux = ranges_[camera], .title = title});
  if (!difference) return difference.error();
  const auto difference_path = folder_ / (io::fileNameOf(layout) + " minus " +
                                          io::fileNameOf(first_layout_) + suffix + ".png");
  io::WriteOptions how;
  how.metadata = {{"Project", project},
                  {"Layout", title},
                  {"Camera", cameras_[camera].name},
                  {"Unit", fmt::format("lx, -{0:g} to +{0:g}", ranges_[camera])}};
  auto saved = io::writeImage(difference_path, *difference, how);
  if (saved) files_.push_back(difference_path.string());
  return saved;
}

}  // namespace soffit::cli

// SPDX-License-Identifier: MIT
// What is read of a view's pictures, and pictures other than the one on the screen.
#include "ui/viewport/picture_pass.h"
#include "ui/viewport/scene_view.h"

#include <algorithm>
#include <utility>

namespace soffit::ui {
namespace {

/// Adds what the pass computed last, turned so that the top row comes first.
void addLinear(const std::vector<float>& pixels, int width, int height, float share,
               std::vector<vec3>& sum) {
  sum.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), vec3(0.0F));
  for (int y = 0; y < height; ++y) {
    const std::size_t from = static_cast<std::size_t>(height - 1 - y);
    for (int x = 0; x < width; ++x) {
      const auto w = static_cast<std::size_t>(width);
      const std::size_t p = 4 * (from * w + static_cast<std::size_t>(x));
      sum[static_cast<std::size_t>(y) * w + static_cast<std::size_t>(x)] +=
          share * vec3(pixels[p], pixels[p + 1], pixels[p + 2]);
    }
  }
}

render::LuxPicture luxOf(const PicturePass& pass) {
  render::LuxPicture picture;
  const auto pixels = pass.readLinear(picture.width, picture.height);
  picture.lux.reserve(pixels.size() / 4);
  const auto width = static_cast<std::size_t>(picture.width);
  for (auto row = static_cast<std::size_t>(picture.height); row-- > 0;) {
    for (std::size_t x = 0; x < width; ++x)
      picture.lux.push_back(pixels[4 * (row * width + x) + 3]);
  }
  return picture;
}

}  // namespace

render::LuxPicture SceneView::readLux() {
  if (!isValid() || mesh_ == nullptr) return {};
  makeCurrent();
  render::LuxPicture picture = luxOf(pass());
  doneCurrent();
  return picture;
}

bool SceneView::isSeen(const ViewCamera& camera, const dvec3& place) const {
  return ui::isSeen(pointable(), camera, place);
}

Picture SceneView::take(const Shot& shot) {
  const bool own_light = shot.frame == nullptr;
  if (!isValid() || mesh_ == nullptr || (!own_light && shot.frame->solver != mesh_solver_)) {
    return {};
  }
  const ViewCamera camera = view_;
  const Look look = look_;
  const auto luminaires = luminaires_;
  if (shot.camera) view_ = *shot.camera;
  if (shot.luminaires != nullptr) luminaires_ = shot.luminaires;
  if (shot.look) (void)pass().display.setLook(*shot.look);
  if (!own_light) lightBuilding(*shot.frame);
  placeCamera();
  drawLuminaires();
  Picture taken;
  const int samples = shot.samples > 0 ? std::min(shot.samples, PicturePass::kMostSamples)
                                       : PicturePass::kMostSamples;
  const auto collect = [&] {
    // The first sample lies in the middle of the pixel.
    if (shot.lux && taken.lux.lux.empty()) taken.lux = luxOf(pass());
    if (!shot.linear) return;
    int width = 0;
    int height = 0;
    const auto pixels = pass().readLinear(width, height);
    addLinear(pixels, width, height, 1.0F / static_cast<float>(samples), taken.linear);
  };
  if (view_.isParallel()) showDrawingLines();
  taken.image = picture(shot.pixels, view_.isParallel(), samples, collect);
  view_ = camera;
  luminaires_ = luminaires;
  if (shot.look) (void)pass().display.setLook(look);
  if (!own_light && frame_ != nullptr && frame_->solver == mesh_solver_) lightBuilding(*frame_);
  restart();
  return taken;
}

std::optional<Still> SceneView::still(const Shot& shot) {
  const LightFramePtr& frame = shot.frame != nullptr ? shot.frame : frame_;
  if (mesh_ == nullptr || frame == nullptr || frame->solver != mesh_solver_) return std::nullopt;
  const ViewCamera camera = view_;
  const auto luminaires = luminaires_;
  if (shot.camera) view_ = *shot.camera;
  if (shot.luminaires != nullptr) luminaires_ = shot.luminaires;
  placeCamera();
  Still still;
  still.shot = shot;
  still.scene = scene_;
  still.mesh = mesh_;
  still.frame = frame;
  still.luminaires = luminaires_;
  still.cut_away = cutAwayLuminaires();
  still.camera = view_;
  still.drawn =
      drawnView(*this->camera(), static_cast<double>(shot.pixels.width()) / shot.pixels.height(),
                view_.isParallel() ? view_.cut_depth : 0.0);
  still.look = shot.look.value_or(look_);
  if (view_.isParallel()) {
    still.lines = {{cutHatch(), kHatchColor, kHatchWidth},
                   {cutLines(), kCutColor, kCutWidth},
                   {planOutlines(), kPlanColor, kPlanWidth}};
  }
  still.view_height = height();
  still.font = font();
  view_ = camera;
  luminaires_ = luminaires;
  placeCamera();
  return still;
}

void SceneView::shareMesh(const SceneView& other) {
  if (other.mesh_ == nullptr || other.mesh_ == mesh_) return;
  mesh_ = other.mesh_;
  mesh_solver_ = other.mesh_solver_;
  pass().building.setMesh(mesh_);
  if (frame_ != nullptr && frame_->solver == mesh_solver_) showLight();
}

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#include "ui/viewport/traced_still.h"

#include "core/color/exposure.h"
#include "core/render/picture.h"
#include "core/render/view_renderer.h"
#include "ui/viewport/traced_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <new>
#include <string_view>

namespace soffit::ui {
namespace {

/// One course from the stages of the renderer, by about what each takes.
class Course : public ProgressObserver {
 public:
  explicit Course(ProgressObserver* whole) : whole_(whole) {}

  void onProgress(std::string_view stage, double done) override {
    struct Part {
      std::string_view stage;
      double from, to;
    };
    constexpr std::array kParts{Part{"computing luminaires", 0.0, 0.15},
                                Part{"following reflections", 0.15, 0.3},
                                Part{"rendering", 0.3, 0.75}, Part{"refining edges", 0.75, 0.8},
                                Part{"refining reflections", 0.8, 1.0}};
    for (const Part& part : kParts) {
      if (part.stage != stage) continue;
      const std::lock_guard lock(mutex_);
      done_ = std::max(done_, part.from + (part.to - part.from) * std::clamp(done, 0.0, 1.0));
      if (whole_ != nullptr) whole_->onProgress("drawing", done_);
    }
  }

 private:
  ProgressObserver* whole_;
  std::mutex mutex_;
  double done_ = 0.0;
};

render::PictureOptions optionsOf(const Look& look) {
  render::PictureOptions options;
  options.display = look.display;
  options.exposure_ev = look.exposure_ev;
  options.tone = look.tone;
  options.adapted_to = look.adapted_to;
  options.bloom = look.bloom;
  return options;
}

/// RGB888. Throws std::bad_alloc.
QImage imageOf(const scene::Image& picture) {
  QImage image(picture.width, picture.height, QImage::Format_RGB888);
  if (image.isNull()) throw std::bad_alloc();
  const float* from = picture.pixels.data();
  for (int y = 0; y < picture.height; ++y) {
    uchar* to = image.scanLine(y);
    for (int i = 0; i < 3 * picture.width; ++i) {
      *to++ = static_cast<uchar>(std::lround(255.0F * std::clamp(*from++, 0.0F, 1.0F)));
    }
  }
  return image;
}

Error cancelled() {
  return {{}, "cancelled", {}};
}

}  // namespace

bool isTraceable(const ViewCamera& camera, const Look& look) {
  return !camera.isParallel() && !look.false_color && !look.difference && look.levels.empty();
}

Result<void> TracedStill::take(const Still& still, const Job& job) {
  if (light_ != nullptr && showsSame(*frame_, *scene_, *still.frame, *still.scene)) return {};
  // Nothing may look at the luminaires while they change.
  light_.reset();
  view_.reset();
  if (lighting_ == nullptr || &lighting_->solver() != still.frame->solver.get()) {
    lighting_ = std::make_shared<relight::Lighting>(still.frame->solver);
  }
  if (const auto set = lighting_->setLuminaires(still.shot.lamps, job); !set) return set.error();
  if (lighting_->environment() != still.frame->outside.get()) {
    if (const auto set = lighting_->setEnvironment(still.frame->outside, job); !set) {
      return set.error();
    }
  }
  if (job.cancelled()) return cancelled();
  const auto emitters = lighting_->emitters();
  const std::shared_ptr<const geometry::RayCaster> caster(lighting_,
                                                          &lighting_->solver().scene().caster);
  auto view = std::make_unique<const render::ViewScene>(
      still.scene, caster, std::vector<light::Emitter>(emitters.begin(), emitters.end()));
  auto light = render::EngineLight::withThrownLight(lighting_, *view, {}, job);
  if (!light) return light.error();
  frame_ = still.frame;
  scene_ = still.scene;
  view_ = std::move(view);
  light_ = std::move(*light);
  return {};
}

void TracedStill::release() {
  light_.reset();
  view_.reset();
  lighting_.reset();
  scene_.reset();
  frame_.reset();
}

Result<render::Film> TracedStill::trace(const Still& still, const Job& job) {
  Course course(job.observer);
  const Job step{&course, job.stop};
  if (const auto taken = take(still, step); !taken) return taken.error();
  render::RenderOptions options;
  options.width = still.shot.pixels.width();
  options.height = still.shot.pixels.height();
  options.samples = still.shot.samples > 0 ? still.shot.samples : PicturePass::kMostSamples;
  if (!still.shot.linear) options.edge_white = 4.0F / color::exposureScale(still.look.exposure_ev);
  return render::renderView(*view_, still.camera.toScene({}), *light_, options, step);
}

Result<Picture> TracedStill::draw(const Still& still, const Job& job) {
  auto film = trace(still, job);
  if (!film) return film.error();
  if (job.cancelled()) return cancelled();
  const auto developed = render::developPicture(*film, optionsOf(still.look));
  if (!developed) return developed.error();
  Picture picture;
  picture.image = imageOf(*developed);
  if (still.shot.linear) picture.linear = std::move(film->radiance);
  return picture;
}

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#include "ui/jobs/verification.h"

#include "core/relight/engine.h"
#include "core/scene/equality.h"
#include "ui/document/text.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace soffit::ui {
namespace {

/// Whether light and the points at which it is verified are the same.
bool sameForLight(const scene::Scene& a, const scene::Scene& b) {
  const bool paint = scene::sameReflectances(a.materials, b.materials);
  const bool outside = a.environment.has_value() == b.environment.has_value() &&
                       (!a.environment || scene::same(*a.environment, *b.environment));
  return paint && outside && scene::sameList(a.work_planes, b.work_planes) &&
         scene::same(a.quality, b.quality) && (a.mesh == b.mesh || scene::same(*a.mesh, *b.mesh));
}

}  // namespace

Verification::Verification(Document& document, Relighting& relighting, QObject* parent)
    : QObject(parent), document_(document), relighting_(relighting) {
  connect(&document_, &Document::sceneChanged, this, &Verification::onSceneChanged);
  connect(&relighting_, &Relighting::frameChanged, this, &Verification::onFrame);
  connect(&relay_, &ProgressRelay::progressed, this, [this](const QString& stage, double done) {
    if (state_ == State::running) Q_EMIT progressed(stage, done);
  });
}

Verification::~Verification() {
  stop_.request_stop();
}

bool Verification::isOfNow(const VerifiedLight& light) const {
  return scene::sameList(light.luminaires, document_.litLuminaires()) &&
         (light.scene == document_.scene() || sameForLight(*light.scene, *document_.scene()));
}

bool Verification::isVerified() const {
  return verified_;
}

void Verification::start(const VerifyWish& wish) {
  stop_.request_stop();
  wish_ = wish;
  state_ = State::waiting;
  Q_EMIT changed();
  onFrame();
}

void Verification::cancel() {
  if (state_ != State::idle) stop({});
}

void Verification::stop(const QString& why) {
  stop_.request_stop();
  under_way_ = nullptr;
  state_ = State::idle;
  Q_EMIT changed();
  Q_EMIT stopped(why);
}

void Verification::onSceneChanged() {
  if (state_ == State::running && !isOfNow(*under_way_)) {
    stop(tr("The light changed while it was being verified: verify it again"));
  }
  const bool verified = result_ != nullptr && isOfNow(*result_);
  if (std::exchange(verified_, verified) != verified) Q_EMIT changed();
}

void Verification::onFrame() {
  if (state_ != State::waiting || !relighting_.isCurrent() || document_.previewing()) return;
  if (relighting_.frame()->solver->operators().coarse) return;
  run();
}

void Verification::run() {
  auto light = std::make_shared<VerifiedLight>();
  light->scene = document_.scene();
  light->luminaires = document_.litLuminaires();
  light->wish = wish_;
  under_way_ = light;
  state_ = State::running;
  stop_ = std::stop_source();
  Q_EMIT changed();
  background_.run([this, light, solver = relighting_.frame()->solver,
                   stop = stop_.get_token()]() -> Background::End {
    const auto start = std::chrono::steady_clock::now();
    design::VerifyOptions options;
    options.effort.error = light->wish.error;
    options.effort.time_limit_s = light->wish.time_limit_s;
    options.luminaire = toStd(light->wish.luminaire);
    if (const auto quality = relight::qualitySettings(light->scene->quality)) {
      options.sensor_rays = quality->sensor_rays;
    }
    scene::Scene scene = *light->scene;
    scene.luminaires = light->luminaires;
    auto report = design::verify(solver, scene, options, Job{&relay_, stop});
    light->seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (stop.stop_requested()) return {};  // told by stop() or start()
    return [this, light, report = std::move(report)]() mutable {
      if (under_way_ != light) return;
      if (!report) {
        this->stop(messageOf(report.error()));
        return;
      }
      light->report = std::move(*report);
      result_ = std::exchange(under_way_, nullptr);
      state_ = State::idle;
      verified_ = isOfNow(*result_);
      Q_EMIT changed();
      Q_EMIT finished();
    };
  });
}

}  // namespace soffit::ui

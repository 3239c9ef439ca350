// SPDX-License-Identifier: MIT
#include "ui/main_window/rest_tracer.h"

#include "ui/document/text.h"
#include "ui/viewport/picture_pass.h"

#include <QSettings>

#include <memory>
#include <new>
#include <utility>

namespace soffit::ui {
namespace {

const QString kSetting = QStringLiteral("view/traced");
/// Two looks that see the same: it rests.
constexpr int kLookMs = 300;
constexpr int kSamples = 4;

/// As SceneView shows it: four floats per pixel, rows upward.
std::vector<float> rowsUpward(const render::Film& film) {
  std::vector<float> light;
  light.reserve(4 * film.count());
  for (int y = film.height; y-- > 0;) {
    for (int x = 0; x < film.width; ++x) {
      const std::size_t at = film.at(x, y);
      const vec3& v = film.radiance[at];
      const bool surface = film.surface[at] > 0.0F;
      const float lux = surface ? film.lux[at] : film.lamp[at] > 0.0F ? -1.0F : -2.0F;
      light.insert(light.end(), {v.x, v.y, v.z, lux});
    }
  }
  return light;
}

}  // namespace

RestTracer::RestTracer(Document& document, Workspace& workspace, Relighting& relighting)
    : document_(document), workspace_(workspace), relighting_(relighting) {
  const RelightWorker& worker = relighting_.worker();
  connect(&worker, &RelightWorker::progressed, this, [this] { computing_ = true; });
  connect(&worker, &RelightWorker::bakeFinished, this, [this] { computing_ = false; });
  connect(&worker, &RelightWorker::lightFinished, this, [this] { computing_ = false; });
  connect(workspace_.status, &StatusLine::cancelRequested, this, [this] {
    if (!under_way_) return;
    given_up_ = under_way_;
    giveUp();
  });
  connect(&relay_, &ProgressRelay::progressed, this, [this](const QString&, double done) {
    if (under_way_) workspace_.status->showProgress(tr("Ray tracing the view"), done);
  });
  clock_.setInterval(kLookMs);
  connect(&clock_, &QTimer::timeout, this, &RestTracer::look);
  setWanted(isWanted());
}

RestTracer::~RestTracer() {
  stop_.request_stop();
  hide();
}

bool RestTracer::isWanted() {
  return QSettings().value(kSetting, false).toBool();
}

void RestTracer::setWanted(bool wanted) {
  QSettings().setValue(kSetting, wanted);
  wanted_ = wanted;
  given_up_.reset();
  if (wanted) {
    clock_.start();
    return;
  }
  clock_.stop();
  giveUp();
  hide();
  if (!background_.isBusy()) tracer_.release();
}

void RestTracer::hide() {
  if (shown_ != nullptr) shown_->showTraced(nullptr);
  shown_.clear();
}

void RestTracer::giveUp() {
  if (!under_way_) return;
  under_way_.reset();
  stop_.request_stop();
  workspace_.status->endProgress();
}

bool RestTracer::same(const Subject& a, const Subject& b) {
  return a.view == b.view && a.camera == b.camera && a.pixels == b.pixels &&
         showsSame(*a.frame, *a.scene, *b.frame, *b.scene);
}

bool RestTracer::canTrace(ViewPane& pane) const {
  SceneView& view = pane.view();
  const bool own = !pane.layout() || *pane.layout() == document_.layout();
  return own && view.isVisible() && !view.isMoving() && !view.pixelSize().isEmpty() &&
         view.frame() != nullptr && view.frame() == relighting_.frame() &&
         view.meshSolver() == view.frame()->solver && isTraceable(view.viewCamera(), view.look());
}

std::optional<RestTracer::Subject> RestTracer::subject() const {
  const bool rests = relighting_.isCurrent() && !computing_ && !document_.previewing() &&
                     document_.hidden().isEmpty() &&
                     workspace_.area->comparison().mode() == ComparisonMode::off;
  if (!rests) return std::nullopt;
  for (ViewPane* pane : {&workspace_.area->active(), &workspace_.area->grid().first()}) {
    if (!canTrace(*pane)) continue;
    SceneView& view = pane->view();
    return Subject{&view, view.viewCamera(), view.frame(), document_.scene(), view.pixelSize()};
  }
  return std::nullopt;
}

void RestTracer::look() {
  std::optional<Subject> now = subject();
  if (under_way_ && !(now && same(*now, *under_way_))) giveUp();
  const bool rests = now && before_ && same(*now, *before_);
  before_ = std::move(now);
  if (!rests || under_way_ || background_.isBusy() || before_->view->showsTraced()) return;
  if (given_up_ && same(*given_up_, *before_)) return;
  start(*before_);
}

void RestTracer::start(const Subject& subject) {
  Shot shot;
  shot.pixels = subject.pixels;
  shot.samples = kSamples;
  shot.traced = true;
  shot.lamps = document_.litLuminaires();
  auto still = subject.view->still(shot);
  if (!still) return;
  under_way_ = subject;
  stop_ = std::stop_source();
  const auto order = std::make_shared<const Still>(std::move(*still));
  background_.run([this, subject, order, stop = stop_.get_token()]() -> Background::End {
    auto film = std::make_shared<Result<render::Film>>([&]() -> Result<render::Film> {
      try {
        return tracer_.trace(*order, Job{&relay_, stop});
      } catch (const std::bad_alloc&) {
        return Error{{}, toStd(tr("There is not enough memory to trace the view")), {}};
      }
    }());
    if (stop.stop_requested()) return {};
    return [this, subject, film] { end(subject, std::move(*film)); };
  });
}

void RestTracer::end(const Subject& subject, Result<render::Film> film) {
  if (!under_way_ || !same(*under_way_, subject)) return;
  under_way_.reset();
  workspace_.status->endProgress();
  if (!film) {
    given_up_ = subject;
    workspace_.log->addWarning(messageOf(film.error()));
    return;
  }
  if (subject.view == nullptr) return;
  if (shown_ != subject.view) hide();
  shown_ = subject.view;
  auto traced = std::make_shared<TracedView>();
  traced->camera = subject.camera;
  traced->frame = subject.frame;
  traced->scene = subject.scene;
  traced->pixels = subject.pixels;
  traced->light = rowsUpward(*film);
  shown_->showTraced(std::move(traced));
  Q_EMIT shown();
}

}  // namespace soffit::ui

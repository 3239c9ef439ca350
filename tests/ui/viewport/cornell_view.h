// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/project.h"
#include "core/relight/engine.h"
#include "ui/document/document.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/view_input.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QSurfaceFormat>
#include <QTest>

#include <functional>
#include <memory>

/// A lit view for tests of what the mouse does in it.
namespace soffit::ui {

/// How long a window may take to show, ms: the machine may be busy.
constexpr int kExposedMs = 60000;

/// The Cornell-like sample with few texels and its light. change: of the scene, before it is lit.
struct Lit {
  io::Project project;
  LightFramePtr frame;
};

inline Lit lightCornell(const std::function<void(scene::Scene&)>& change = {}) {
  auto project = io::loadProject(SOFFIT_SOURCE_DIR "/projects/cornell");
  project->scene.quality.settings = {{"texels", 1500},  {"trainings", 8}, {"field_rays", 8},
                                     {"list_rays", 16}, {"node_rays", 4}, {"max_rank", 8}};
  if (change) change(project->scene);
  relight::EngineReport report;
  const auto quality = relight::qualitySettings(project->scene.quality);
  const auto solver = relight::makeSolver(project->scene, *quality, false, {}, report);
  relight::Lighting lighting(*solver);
  (void)lighting.setLuminaires(project->scene.luminaires);
  auto frame = std::make_shared<LightFrame>();
  frame->solver = *solver;
  frame->lux = lighting.total();
  frame->emitters.assign(lighting.emitters().begin(), lighting.emitters().end());
  return {std::move(*project), std::move(frame)};
}

/// A document of it and a view that is wired to it as in the application.
struct CornellView {
  explicit CornellView(const Lit& lit)
      : document(std::make_unique<Document>(lit.project)), view(std::make_unique<SceneView>()) {
    document->setLayout({});
    view->resize(640, 400);
    view->setScene(document->scene());
    place();
    QObject::connect(document.get(), &Document::sceneChanged, view.get(), [this] { place(); });
    QObject::connect(document.get(), &Document::selectionChanged, view.get(),
                     [this] { view->setSelection(document->selection()); });
    input = std::make_unique<ViewInput>(*view);
    input->setDocument(document.get());
    view->setViewCamera(ViewCamera::from(document->scene()->cameras.front()));
  }
  ~CornellView() {
    input.reset();
    view.reset();
  }
  CornellView(const CornellView&) = delete;
  CornellView& operator=(const CornellView&) = delete;

  /// Shows it and waits for its first lit picture.
  [[nodiscard]] bool show(const LightFramePtr& frame) {
    if (!view->setLook({})) return false;
    view->show();
    if (!QTest::qWaitForWindowExposed(view.get(), kExposedMs)) return false;
    QSignalSpy shown(view.get(), &SceneView::lightShown);
    view->setFrame(frame);
    return !shown.isEmpty() || shown.wait(20000);
  }
  void place() const {
    view->setScene(document->scene());
    view->setLuminaires(std::make_shared<const EmitterSet>(document->luminaires(),
                                                           document->scene()->mesh->origin));
  }
  [[nodiscard]] QPoint pixelOf(const dvec3& p) const {
    const dvec3 at = view->viewCamera().project(p, view->viewSize());
    return {static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))};
  }
  [[nodiscard]] const light::Luminaire& first() const { return document->luminaires().front(); }
  [[nodiscard]] QString firstName() const { return QString::fromStdString(first().name); }

  void press(const QPoint& at, Qt::KeyboardModifiers keys = {}) const {
    QTest::mousePress(view.get(), Qt::LeftButton, keys, at);
  }
  void moveTo(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {}) const {
    constexpr int kSteps = 12;
    for (int i = 1; i <= kSteps; ++i) {
      // QTest::mouseMove knows no modifiers.
      const QPointF at = QPointF(from) + QPointF(to - from) * i / kSteps;
      QMouseEvent event(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                        keys);
      QApplication::sendEvent(view.get(), &event);
    }
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {}) const {
    press(from, keys);
    moveTo(from, to, keys);
    QTest::mouseRelease(view.get(), Qt::LeftButton, keys, to);
  }

  std::unique_ptr<Document> document;
  std::unique_ptr<SceneView> view;
  std::unique_ptr<ViewInput> input;
};

/// The surface format that views need; before the QApplication.
inline void wantOpenGl() {
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(0);
  QSurfaceFormat::setDefaultFormat(format);
}

}  // namespace soffit::ui

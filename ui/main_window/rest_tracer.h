// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/jobs/background.h"
#include "ui/jobs/progress_relay.h"
#include "ui/jobs/relighting.h"
#include "ui/main_window/workspace.h"
#include "ui/viewport/traced_still.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <optional>
#include <stop_token>

namespace soffit::ui {

/// Ray traces the view once everything rests: reflections, and shadows of each pixel. Any change of
/// camera, light or materials brings the live picture back at once. Off until it is wanted; a
/// setting of the user's, not of the project.
///
/// One view is traced: the active one, or the first while that is flat or shows numbers.
class RestTracer : public QObject {
  Q_OBJECT

 public:
  RestTracer(Document& document, Workspace& workspace, Relighting& relighting);
  ~RestTracer() override;

  /// The user's setting.
  [[nodiscard]] static bool isWanted();
  void setWanted(bool wanted);
  [[nodiscard]] bool isBusy() const { return under_way_.has_value(); }

 Q_SIGNALS:
  /// A traced picture is on the screen.
  void shown();

 private:
  /// What would be traced.
  struct Subject {
    QPointer<SceneView> view;
    ViewCamera camera;
    LightFramePtr frame;
    ScenePtr scene;
    QSize pixels;
  };
  [[nodiscard]] static bool same(const Subject& a, const Subject& b);
  [[nodiscard]] bool canTrace(ViewPane& pane) const;
  [[nodiscard]] std::optional<Subject> subject() const;
  void look();
  void start(const Subject& subject);
  void end(const Subject& subject, Result<render::Film> film);
  void giveUp();
  void hide();

  Document& document_;
  Workspace& workspace_;
  Relighting& relighting_;
  bool wanted_ = false;
  bool computing_ = false;         ///< the engine is at work on better light
  std::optional<Subject> before_;  ///< at the last look
  std::optional<Subject> under_way_;
  std::optional<Subject> given_up_;  ///< nobody wants to wait for this one
  QPointer<SceneView> shown_;
  std::stop_source stop_;
  QTimer clock_;
  TracedStill tracer_;
  ProgressRelay relay_;
  Background background_;
};

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/camera_history.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/walking.h"

#include <QElapsedTimer>
#include <QObject>
#include <QPointF>
#include <QTimer>

#include <set>

class QKeyEvent;

namespace soffit::ui {

/// How mouse and keys move the camera of a view, and the way back to where it was.
///
/// Orbit, pan, look round, and toward what is under the mouse; while looking round W, A, S, D walk,
/// Q and E go down and up, Shift goes faster, the wheel sets the speed. Plans, elevations and
/// sections are moved in their plane alone; there Control and the wheel move the cut.
class CameraControl : public QObject {
  Q_OBJECT

 public:
  enum class Way { none, orbit, pan, look };

  /// The view must outlive this.
  explicit CameraControl(SceneView& view);

  /// A drag of the camera from what is under the mouse.
  void begin(Way way, const PointedAt& from);
  void moveBy(const QPointF& pixels);
  void end();
  [[nodiscard]] Way way() const { return way_; }
  /// notches: up is toward what is under the mouse.
  void wheel(double notches, const PointedAt& at, const QPointF& mouse, bool cut);

  /// Whether a key is for walking now; such keys are no shortcuts.
  [[nodiscard]] bool wantsKey(const QKeyEvent& event) const;
  void key(const QKeyEvent& event, bool pressed);

  void back();
  void forward();
  [[nodiscard]] const CameraHistory& history() const { return history_; }
  /// Another project: no way back into the one before.
  void forget() { history_.clear(); }

 Q_SIGNALS:
  /// What can be done while walking; empty: it is over.
  void hintChanged(const QString& hint);

 private:
  void onMoved();
  void step();
  void setMoving();
  [[nodiscard]] Walking::Wish wish() const;
  void showHint();

  SceneView& view_;
  Way way_ = Way::none;
  dvec3 pivot_{0.0};
  Walking walking_;
  dvec3 stood_{0.0};  ///< where the last walk ended
  std::set<int> keys_;
  QTimer steps_;
  QElapsedTimer clock_;
  QTimer wheel_rest_;
  QTimer settling_;
  CameraHistory history_;
};

}  // namespace soffit::ui

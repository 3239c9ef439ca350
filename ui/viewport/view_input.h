// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/viewport/camera_control.h"
#include "ui/viewport/drag_session.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/view_overlay.h"
#include "ui/viewport/view_tool.h"

#include <QEvent>
#include <QObject>
#include <QPointF>

#include <memory>
#include <optional>

class QDropEvent;
class QMouseEvent;
class QWheelEvent;
class QKeyEvent;

namespace soffit::ui {

/// What mouse and keys do in a view.
///
/// Left: select; drag a luminaire (along the plane it hangs in, in flat views along theirs) or the
/// gizmo; drag elsewhere to orbit about the point under the mouse, or to shift a flat view. Shift,
/// Control and a click: add and remove; and a drag from an empty place: a rubber band. Shift and a
/// drag of a luminaire: a copy. Middle, or Shift and right: pan. Right: look round, and walk with
/// W, A, S, D (CameraControl). Wheel: toward the point under the mouse. While dragging: Control for
/// whole steps, Alt free of snapping, X, Y, Z and numbers (DragSession). Escape: back.
class ViewInput : public QObject {
  Q_OBJECT

 public:
  /// The view must outlive this. document may be null until setDocument().
  explicit ViewInput(SceneView& view, QObject* parent = nullptr);
  ~ViewInput() override;
  void setDocument(Document* document);
  /// Nothing can be chosen or moved: what is shown is not what is edited.
  void setOnlyLooking(bool only);

  void setGizmoTool(GizmoTool tool);
  [[nodiscard]] SnapRules& snapRules() { return rules_; }
  /// Clicks belong to a tool until it is finished, given up, or another comes.
  void setTool(std::unique_ptr<ViewTool> tool);
  [[nodiscard]] ViewTool* tool() { return tool_.get(); }
  [[nodiscard]] ViewOverlay& overlay() { return *overlay_; }
  [[nodiscard]] CameraControl& camera() { return camera_; }

 Q_SIGNALS:
  /// What the mouse points at, at each move.
  void pointed(const PointedAt& at);
  void left();
  /// A luminaire was double-clicked.
  void editRequested();
  /// A surface was clicked, not a luminaire.
  void surfaceClicked(const SurfaceReading& surface);
  void surfaceDoubleClicked(const SurfaceReading& surface);
  void gizmoToolChanged(GizmoTool tool);
  /// What the tool asks for; empty: none is at work.
  void hintChanged(const QString& hint);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Mode { none, pressed, camera, drag, band, tool };
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool doubleClick(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool key(const QKeyEvent& event);
  bool drop(QDropEvent& event, QEvent::Type what);
  bool wantsKey(const QKeyEvent& event) const;
  void click(const QMouseEvent& event);
  void select(const std::string& name, bool add);
  void beginPressed(const QMouseEvent& event);
  void endBand(const QMouseEvent& event);
  void hover(const QMouseEvent& event);
  void endMode();

  SceneView& view_;
  CameraControl camera_;
  ViewOverlay* overlay_;
  Document* document_ = nullptr;
  bool only_looking_ = false;
  Mode mode_ = Mode::none;
  QPointF start_;
  QPointF last_;
  PointedAt pressed_;
  GizmoPart pressed_part_ = GizmoPart::none;
  SnapRules rules_;
  std::unique_ptr<DragSession> drag_;
  std::unique_ptr<ViewTool> tool_;
};

}  // namespace soffit::ui

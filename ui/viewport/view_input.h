// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/viewport/scene_view.h"

#include <QElapsedTimer>
#include <QObject>
#include <QPointF>

#include <optional>

class QMouseEvent;
class QWheelEvent;
class QKeyEvent;

namespace soffit::ui {

/// What mouse and keys do in a view.
///
/// Left: select; drag a luminaire (along the plane it hangs in) or the gizmo; drag elsewhere to
/// orbit about the point under the mouse. Middle, or Shift and left: pan. Right: look round. Wheel:
/// toward the point under the mouse. Control while dragging: steps of 0.1 m. Escape: back.
class ViewInput : public QObject {
  Q_OBJECT

 public:
  /// Both must outlive this. document may be null until setDocument().
  explicit ViewInput(SceneView& view, QObject* parent = nullptr);
  void setDocument(Document* document) { document_ = document; }

 Q_SIGNALS:
  /// What the mouse points at, at each move.
  void pointed(const PointedAt& at);
  void left();
  /// A luminaire was double-clicked.
  void editRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Mode { none, pressed, orbit, pan, look, drag };
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool key(const QKeyEvent& event);
  void select(const std::string& name, bool add);
  void beginPressed(const QMouseEvent& event);
  void hover(const QPointF& mouse);
  void dragTo(const QPointF& mouse, bool stepped);
  void endMode();

  SceneView& view_;
  Document* document_ = nullptr;
  Mode mode_ = Mode::none;
  QPointF start_;
  QPointF last_;
  PointedAt pressed_;
  GizmoPart pressed_part_ = GizmoPart::none;
  dvec3 pivot_{0.0};
  std::optional<Gizmo> gizmo_;
  dvec3 gizmo_start_{0.0};
  QTimer wheel_rest_;
};

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/pointing.h"
#include "ui/viewport/view_overlay.h"

#include <QKeyEvent>
#include <QObject>
#include <QPointF>

namespace soffit::ui {

/// What a click means while something else than selecting is going on: placing, aiming, drawing.
/// The camera keeps its buttons; dragging with the left one still orbits.
class ViewTool : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// The mouse without a button.
  virtual void hover(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) = 0;
  virtual void click(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) = 0;
  virtual void doubleClick() {}
  /// A press on something of its own that is dragged then; else a drag moves the camera.
  virtual bool grab(const QPointF&) { return false; }
  virtual void dragTo(const QPointF&) {}
  virtual void letGo() {}
  /// It is over: takes back what was not finished.
  virtual void end() {}
  /// Whether it uses a key that would be a shortcut of the menus otherwise (beside Return, Enter
  /// and Backspace).
  [[nodiscard]] virtual bool wantsKey(const QKeyEvent&) const { return false; }
  /// Whether a key was used. Escape ends every tool and does not come here.
  virtual bool key(const QKeyEvent&) { return false; }
  /// What to do, for the status line.
  [[nodiscard]] virtual QString hint() const = 0;

 Q_SIGNALS:
  /// What the view is to show of it.
  void contentChanged(const ViewOverlay::Content& content);
  void hintChanged(const QString& hint);
  /// The tool has done its work.
  void finished();
};

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/viewport/luminaire_drag.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/view_overlay.h"

#include <QCoreApplication>
#include <QPointF>

class QKeyEvent;

namespace soffit::ui {

/// A drag of the selection between press and release: a preview of the document that ends in one
/// undo step, or in none.
class DragSession {
  Q_DECLARE_TR_FUNCTIONS(DragSession)

 public:
  /// part: of the gizmo, or `free` for the luminaires themselves. copies: the originals stay, and
  /// copies of them are dragged; the copies are selected.
  DragSession(SceneView& view, ViewOverlay& overlay, Document& document, GizmoTool tool,
              GizmoPart part, const QPointF& mouse, bool copies, const SnapRules& rules);
  /// Gives up what was not committed.
  ~DragSession();
  DragSession(const DragSession&) = delete;
  DragSession& operator=(const DragSession&) = delete;

  void moveTo(const QPointF& mouse, Qt::KeyboardModifiers modifiers);
  /// X, Y, Z lock an axis; digits, signs and units are a typed value. Whether it was used.
  bool key(const QKeyEvent& event);
  void commit();

 private:
  void show();
  [[nodiscard]] QString stepText() const;

  SceneView& view_;
  ViewOverlay& overlay_;
  Document& document_;
  bool copies_;
  QStringList originals_;
  QStringList names_;
  std::optional<LuminaireDrag> drag_;
};

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/snapping.h"
#include "ui/viewport/view_tool.h"

#include <vector>

namespace soffit::ui {

/// Draws a luminaire's outline corner by corner in the plane of the ceiling: each click is a
/// corner, right angles to the last edge attract, Backspace takes a corner back, Enter, a double
/// click or a click on the first corner closes it. Control: a grid of 0.1 m; Alt: no right angles.
class DrawingPolygon : public ViewTool {
  Q_OBJECT

 public:
  DrawingPolygon(Document& document, SceneView& view) : document_(document), view_(view) {}
  void hover(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) override;
  void click(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) override;
  void doubleClick() override { close(); }
  bool key(const QKeyEvent& event) override;
  [[nodiscard]] QString hint() const override;
  [[nodiscard]] const std::vector<dvec3>& corners() const { return corners_; }

 private:
  [[nodiscard]] std::optional<dvec3> cornerAt(const PointedAt& at, const QPointF& mouse,
                                              Qt::KeyboardModifiers keys) const;
  [[nodiscard]] bool closesAt(const dvec3& corner) const;
  void show(const std::optional<dvec3>& next);
  void close();

  Document& document_;
  SceneView& view_;
  std::vector<dvec3> corners_;
};

}  // namespace soffit::ui

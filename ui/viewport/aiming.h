// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/viewport/view_tool.h"

namespace soffit::ui {

/// Aims the selected luminaires at the point of a surface that is clicked. Shift and a click: goes
/// on aiming.
class Aiming : public ViewTool {
  Q_OBJECT

 public:
  explicit Aiming(Document& document) : document_(document) {}
  void hover(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) override;
  void click(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) override;
  [[nodiscard]] QString hint() const override;

 private:
  Document& document_;
};

}  // namespace soffit::ui

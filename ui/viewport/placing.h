// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/viewport/placement.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/view_tool.h"

namespace soffit::ui {

/// Places a luminaire of a kind with a click: its outline follows the mouse, Space turns it by 90
/// degrees, Alt frees it of snapping, Shift and a click goes on placing. One undo step each.
class Placing : public ViewTool {
  Q_OBJECT

 public:
  Placing(Document& document, SceneView& view, LuminaireType type, const SnapRules& rules);
  void hover(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) override;
  void click(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) override;
  bool key(const QKeyEvent& event) override;
  [[nodiscard]] bool wantsKey(const QKeyEvent& event) const override;
  [[nodiscard]] QString hint() const override;
  [[nodiscard]] const LuminaireType& type() const { return type_; }

 private:
  [[nodiscard]] std::optional<Placement> placementAt(const PointedAt& at,
                                                     Qt::KeyboardModifiers keys) const;
  void show(const std::optional<Placement>& placement);

  Document& document_;
  SceneView& view_;
  LuminaireType type_;
  SnapRules rules_;
  double turn_deg_ = 0.0;
  PointedAt last_;
  Qt::KeyboardModifiers last_keys_;
};

/// Adds a luminaire of a kind to the layout that is shown, with its files, as one undo step, and
/// selects it.
void addLuminaire(Document& document, const LuminaireType& type, light::Luminaire luminaire);

}  // namespace soffit::ui

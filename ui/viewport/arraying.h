// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/document/luminaire_array.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/view_tool.h"

namespace soffit::ui {

/// Makes an array of the selected luminaire, live: settings that are typed, handles in the view
/// that are dragged (squares for the spacing, disks for the count). Enter or apply() makes it one
/// undo step; Escape leaves all as it was.
class Arraying : public ViewTool {
  Q_OBJECT

 public:
  /// The first luminaire that is selected is repeated, and is itself the array's first.
  Arraying(Document& document, SceneView& view, ArrayKind kind);

  void setSettings(const ArraySettings& settings);
  /// As they are asked for: a spacing of 0 follows the count.
  [[nodiscard]] const ArraySettings& wanted() const { return settings_; }
  /// As they could be kept.
  [[nodiscard]] const ArrayPlan& plan() const { return plan_; }
  void apply();

  void hover(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) override;
  void click(const PointedAt&, const QPointF&, Qt::KeyboardModifiers) override {}
  bool grab(const QPointF& mouse) override;
  void dragTo(const QPointF& mouse) override;
  void letGo() override;
  void end() override;
  bool key(const QKeyEvent& event) override;
  [[nodiscard]] QString hint() const override;

 Q_SIGNALS:
  void planChanged(const ArrayPlan& plan, const ArraySettings& wanted);

 private:
  enum class Handle { none, spacing_x, spacing_y, columns, rows };
  struct Grip {
    Handle handle = Handle::none;
    dvec3 at{0.0};
  };
  [[nodiscard]] std::vector<Grip> grips() const;
  [[nodiscard]] Handle handleAt(const QPointF& mouse) const;
  [[nodiscard]] std::optional<dvec2> onPlan(const QPointF& mouse) const;
  void update();
  void show();

  Document& document_;
  SceneView& view_;
  light::Luminaire seed_;
  ScenePtr before_;
  ArrayField field_;
  dvec2 size_{0.0};
  ArraySettings settings_;
  ArrayPlan plan_;
  Handle lit_ = Handle::none;
  Handle held_ = Handle::none;
  dvec2 held_from_{0.0};
  ArraySettings held_settings_;
  bool updating_ = false;
};

}  // namespace soffit::ui

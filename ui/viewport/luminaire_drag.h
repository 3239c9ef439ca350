// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/luminaire.h"
#include "ui/viewport/gizmo.h"
#include "ui/viewport/gizmo_scaling.h"
#include "ui/viewport/gizmo_turning.h"
#include "ui/viewport/snapping.h"

#include <QString>

#include <optional>

namespace soffit::ui {

/// What a view shows of a drag, world coordinates.
struct DragReadout {
  QString text;                        ///< at the gizmo
  dvec3 at{0.0};                       ///< where the gizmo is now
  std::vector<Snapped::Guide> guides;  ///< what it snapped to
  std::vector<Clearance> clearances;   ///< distances to walls and neighbours
};

/// One drag of the gizmo: what the mouse, axis locks and typed numbers do to the luminaires that
/// are moved, turned or resized together. Knows neither widgets nor the document.
class LuminaireDrag {
 public:
  struct Start {
    GizmoTool tool = GizmoTool::move;
    GizmoPart part = GizmoPart::free;
    dvec3 pivot{0.0};      ///< where the gizmo is, world
    dmat3 frame{1.0};      ///< the axes of the scaling handles
    dvec3 half_size{0.0};  ///< of all that is moved, about the pivot, world axes
    ViewCamera camera;
    dvec2 view_size{1.0};
    dvec2 mouse{0.0};
  };
  LuminaireDrag(const Start& start, Surroundings around, const SnapRules& rules);

  /// stepped: whole steps (0.1 m, 15 degrees, 10 %). free: no snapping at all.
  void moveTo(const dvec2& mouse, bool stepped, bool free);

  /// A key of the lock: the same axis again unlocks it. Rings and handles change over to it.
  void lockAxis(int axis);
  /// A character of a number, '\b' takes one back. Whether it is used.
  bool type(QChar character);
  [[nodiscard]] const QString& typed() const { return typed_; }

  /// The drag as it stands, on a luminaire as it was at the start.
  void apply(light::Luminaire& luminaire) const;
  [[nodiscard]] DragReadout readout() const;
  [[nodiscard]] GizmoTool tool() const { return start_.tool; }
  [[nodiscard]] GizmoPart part() const { return part_; }
  [[nodiscard]] dvec3 offset() const { return offset_; }

 private:
  void restart();
  void update();
  void updateMove();
  void updateTurn();
  void updateScale();
  [[nodiscard]] glm::bvec3 axes() const;
  [[nodiscard]] std::optional<double> typedValue() const;
  [[nodiscard]] dvec3 factors() const;

  Start start_;
  Surroundings around_;
  SnapRules rules_;
  GizmoPart part_;
  std::optional<Gizmo> moving_;
  std::optional<Turning> turning_;
  std::optional<Scaling> scaling_;
  dvec2 mouse_;
  bool stepped_ = false;
  bool free_ = false;
  QString typed_;

  dvec3 offset_{0.0};
  double angle_deg_ = 0.0;
  double factor_ = 1.0;
  std::vector<Snapped::Guide> guides_;
};

}  // namespace soffit::ui

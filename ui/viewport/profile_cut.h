// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/light_frame.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/view_tool.h"
#include "ui/widgets/profile_chart.h"

#include <optional>
#include <vector>

namespace soffit::ui {

/// A line over a flat surface, along which light is read.
struct ProfileCut {
  dvec3 from{0.0};
  dvec3 to{0.0};
  dvec3 normal{0.0, 0.0, 1.0};  ///< of the side that is read, unit
};

/// The light along a cut, at even steps. Where the surface ends, or something stands on it, there
/// is none (below 0).
std::vector<ProfileChart::Point> profileOf(const ProfileCut& cut, const LightFrame& frame,
                                           const scene::Scene& scene);

/// Draws a profile cut: a click is its start, the next one its end, in the plane of the surface
/// where it began.
class DrawingProfile : public ViewTool {
  Q_OBJECT

 public:
  explicit DrawingProfile(SceneView& view) : view_(view) {}
  void hover(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) override;
  void click(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) override;
  [[nodiscard]] QString hint() const override;

 Q_SIGNALS:
  /// As it stands under the mouse, and at last as it was drawn.
  void cutChanged(const ProfileCut& cut);

 private:
  [[nodiscard]] std::optional<ProfileCut> cutTo(const QPointF& mouse) const;

  SceneView& view_;
  std::optional<ProfileCut> start_;
};

}  // namespace soffit::ui

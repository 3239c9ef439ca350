// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "ui/viewport/gizmo.h"
#include "ui/viewport/view_camera.h"

namespace soffit::ui {

/// The arithmetic of pulling things larger and smaller along axes of their own; knows neither
/// widgets nor VTK.
class Scaling {
 public:
  static constexpr double kMiddle = 0.11;  ///< half the middle cube, of an arrow's length

  /// The handle under the mouse. frame: the axes of the handles, columns.
  static GizmoPart partAt(const dvec3& at, const dmat3& frame, const ViewCamera& camera,
                          const dvec2& size, const dvec2& mouse);

  /// Starts to pull a handle from the mouse.
  Scaling(GizmoPart part, const dvec3& at, const dmat3& frame, const ViewCamera& camera,
          const dvec2& size, const dvec2& mouse);
  /// The factor at a place of the mouse, at least 0.01: for an axis, how far out the handle is
  /// against the start; for the middle, doubled by 100 pixels to the right or upward.
  [[nodiscard]] double factor(const dvec2& mouse) const;

 private:
  GizmoPart part_;
  dvec2 start_;
  dvec2 middle_;
  dvec2 along_{1.0, 0.0};  ///< unit, pixels
};

}  // namespace soffit::ui

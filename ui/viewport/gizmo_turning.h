// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "ui/viewport/gizmo.h"
#include "ui/viewport/view_camera.h"

namespace soffit::ui {

/// The arithmetic of turning things by rings about the world's axes; knows neither widgets nor VTK.
class Turning {
 public:
  static constexpr double kRingRadius = 0.86;  ///< of an arrow's length

  /// The ring under the mouse; of two, the one nearer to the eye.
  static GizmoPart partAt(const dvec3& at, const ViewCamera& camera, const dvec2& size,
                          const dvec2& mouse);

  /// Starts to turn by a ring (x, y or z) from the mouse.
  Turning(GizmoPart ring, const dvec3& at, const ViewCamera& camera, const dvec2& size,
          const dvec2& mouse);
  /// Degrees since the start, counter-clockwise seen from the axis' tip; goes on past a full turn.
  /// A ring seen end on turns with the way of the mouse along it.
  double angleDeg(const ViewCamera& camera, const dvec2& size, const dvec2& mouse);

 private:
  [[nodiscard]] double roundAxis(const ViewCamera& camera, const dvec2& size,
                                 const dvec2& mouse) const;

  int axis_;
  dvec3 at_;
  dvec2 start_;
  bool end_on_;
  dvec2 along_{1.0, 0.0};  ///< the ring's direction where it was grabbed, radians per pixel
  double last_ = 0.0;
  double angle_ = 0.0;
};

}  // namespace soffit::ui

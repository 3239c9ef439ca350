// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "ui/viewport/view_camera.h"

#include <optional>

namespace soffit::ui {

/// The parts of the gizmo that can be grabbed: an arrow moves along an axis, a plane along the two
/// others. `free` is the luminaire itself, moved along the horizontal plane that it hangs in.
enum class GizmoPart { none, x, y, z, yz, zx, xy, free };

/// The arithmetic of moving things by arrows and planes; knows neither widgets nor VTK.
///
/// The gizmo keeps its size in pixels. World axes.
class Gizmo {
 public:
  static constexpr double kArrowPixels = 84.0;
  static constexpr double kPlaneFrom = 0.26;  ///< of an arrow's length
  static constexpr double kPlaneTo = 0.50;

  /// Metres per arrow at this camera.
  static double arrowLength(const dvec3& at, const ViewCamera& camera, const dvec2& size);
  /// The part under the mouse; arrows win where they meet a plane. Parts seen end on are not there.
  static GizmoPart partAt(const dvec3& at, const ViewCamera& camera, const dvec2& size,
                          const dvec2& mouse);
  /// Whether a part is seen end on, so that the mouse could not move it in a controlled way.
  static bool isEdgeOn(GizmoPart part, const dvec3& at, const ViewCamera& camera);

  /// Starts a drag of `part` from the mouse.
  Gizmo(GizmoPart part, const dvec3& at, const ViewCamera& camera, const dvec2& size,
        const dvec2& mouse);
  /// Where the thing is when the mouse is there; its last place where the part has no answer
  /// (beyond the horizon).
  dvec3 moved(const ViewCamera& camera, const dvec2& size, const dvec2& mouse);
  [[nodiscard]] GizmoPart part() const { return part_; }

 private:
  [[nodiscard]] std::optional<dvec3> grip(const ViewCamera& camera, const dvec2& size,
                                          const dvec2& mouse) const;

  GizmoPart part_;
  dvec3 start_;
  dvec3 offset_{0.0};  ///< from what the mouse grips to the thing
  dvec3 last_;
};

/// Unit vector of a world axis, 0..2.
dvec3 axisOf(int axis);

}  // namespace soffit::ui

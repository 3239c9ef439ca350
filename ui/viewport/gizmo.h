// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "ui/viewport/view_camera.h"

#include <optional>

namespace soffit::ui {

/// What the gizmo does: arrows and planes, rings, or handles to pull.
enum class GizmoTool { move, rotate, scale };

/// The parts of the gizmo that can be grabbed. Moving: an arrow moves along an axis, a plane along
/// the two others; `free` is the luminaire itself, moved along the horizontal plane that it hangs
/// in. Rotating: the rings about x, y and z. Scaling: the handles along x, y and z, and `free`, the
/// cube in the middle, for all at once.
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

/// The axis of an arrow, a ring or a handle, or the normal of a plane; 2 for `free`.
int axisIndexOf(GizmoPart part);
/// The part that a luminaire itself is, taken hold of in a view: `free`, or the plane that a plan
/// or an elevation shows.
GizmoPart freePart(const ViewCamera& camera);
/// Whether a part is one of x, y and z.
bool isAxis(GizmoPart part);

/// Where a ray meets a plane, in front of the eye; nothing when it runs along it.
std::optional<dvec3> onPlane(const dvec3& at, const dvec3& normal, const dvec3& eye,
                             const dvec3& ray);
/// Distance of a pixel to the line between two others.
double distanceToSegment(const dvec2& p, const dvec2& a, const dvec2& b);

}  // namespace soffit::ui

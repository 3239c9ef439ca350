// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/gizmo.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

class vtkRenderer;

namespace soffit::ui {

/// Draws the gizmo in the overlay, in the axes' colours, the part under the mouse in yellow: three
/// arrows and three planes, three rings, or three handles about a cube.
class GizmoActor {
 public:
  explicit GizmoActor(vtkRenderer* overlay);
  ~GizmoActor();

  void hide();
  /// at: scene-local. frame: the axes, columns. length: of an arrow, m. edge_on: arrows and planes
  /// that are seen end on and left out.
  void show(GizmoTool tool, const dvec3& at, const dmat3& frame, double length,
            GizmoPart highlighted, const std::array<bool, 6>& edge_on);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Draws lines in the overlay: outlines of what is selected or pointed at.
class OutlineActor {
 public:
  OutlineActor(vtkRenderer* overlay, const vec3& color, float width);
  ~OutlineActor();
  /// Two ends in a row, scene-local; empty hides it.
  void setLines(std::span<const vec3> ends);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/gl_objects.h"
#include "ui/viewport/outside_look.h"

namespace soffit::ui {

/// Draws what lies beyond a scene, where nothing else was drawn, and the panes before all of it:
/// clear glass, which dims what is seen through it as in core/render. Part of BuildingDrawing's
/// picture, into the framebuffer that is bound.
class OutsideDrawing {
 public:
  void setEnvironment(const std::optional<scene::Environment>& environment);
  void setPanes(std::vector<PaneCorner> corners);

  /// The surroundings, as far away as the depth buffer goes; `beyond` into the alpha channel. Of a
  /// perspective camera.
  void drawOutside(const glm::mat4& clip_from_scene, float beyond);
  /// eye: as SeenSurfaces takes it. Depth and alpha stay.
  void drawPanes(const glm::mat4& clip_from_scene, const glm::vec4& eye);
  void release();

 private:
  void upload();
  void setSky(const SkyLook& sky) const;

  std::optional<scene::Environment> environment_;
  OutsideLook look_;
  std::vector<PaneCorner> corners_;
  bool picture_dirty_ = false;
  bool corners_dirty_ = false;
  GlProgram outside_program_;
  GlProgram pane_program_;
  GlTexture picture_;
  GlBuffer corner_buffer_;
  unsigned pane_array_ = 0;
  unsigned empty_array_ = 0;
};

}  // namespace soffit::ui

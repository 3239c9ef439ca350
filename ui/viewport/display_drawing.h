// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/gl_objects.h"
#include "ui/viewport/look.h"

#include <QString>

namespace soffit::ui {

/// The view transform on the graphics card: from BuildingDrawing's picture to code values, equal to
/// color::DisplayTransform and render::developPicture() within one code value. Draws a screen-wide
/// triangle into the framebuffer that is bound.
class DisplayDrawing {
 public:
  /// Takes effect with the next draw(); the shader is rebuilt only when the view changes.
  /// Errors (of makeDisplayShader) keep the view that was there.
  Result<void> setLook(const Look& look);

  /// picture_height: of the whole picture, of which the target is a piece; 0: it is all of it.
  void draw(const GlTarget& scene_linear, int picture_height = 0);
  /// Copies a finished picture, scaled; opacity < 1 blends it over what is there.
  void copy(const GlTarget& picture, float opacity = 1.0F);
  void release();

 private:
  void build();
  void setScale(int height);
  void drawTriangle();

  Look look_;
  color::DisplayShader shader_;
  bool dirty_ = false;
  GlProgram program_;
  GlProgram copy_program_;
  std::vector<GlTexture> tables_;
  unsigned array_ = 0;
};

}  // namespace soffit::ui

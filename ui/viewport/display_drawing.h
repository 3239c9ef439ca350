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

  /// Where a target lies in its picture, x to the right, y up, both 0..1.
  struct Part {
    vec2 from{0.0F};
    vec2 size{1.0F};
    int picture_height = 0;  ///< pixels; 0: the target's
  };
  /// Learns from the whole picture, of any size, what the view adapts to and what light is spread
  /// (render::spreadLight()); later draw()s show that. Costs nothing where the look asks for
  /// neither.
  void learn(const GlTarget& scene_linear);
  /// Whether learn() does anything.
  [[nodiscard]] bool learns() const;
  /// What the view is adapted to.
  [[nodiscard]] const color::PictureLuminance& adaptation() const { return adaptation_; }

  void draw(const GlTarget& scene_linear, const Part& part);
  void draw(const GlTarget& scene_linear) { draw(scene_linear, Part{}); }
  /// Copies a finished picture, scaled; opacity < 1 blends it over what is there.
  void copy(const GlTarget& picture, float opacity = 1.0F);
  void release();

 private:
  void build();
  void setScale(int height);
  void setFinish(const Part& part);
  void drawTriangle();

  Look look_;
  color::DisplayShader shader_;
  bool dirty_ = false;
  GlProgram program_;
  GlProgram copy_program_;
  std::vector<GlTexture> tables_;
  color::PictureLuminance adaptation_;
  bool blooms_ = false;  ///< spread_ holds light
  GlTexture spread_;
  unsigned array_ = 0;
};

}  // namespace soffit::ui

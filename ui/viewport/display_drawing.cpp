// SPDX-License-Identifier: MIT
#include <vtk_glew.h>

#include "ui/viewport/display_drawing.h"

#include "core/color/exposure.h"
#include "core/render/difference_picture.h"

#include <cmath>

namespace soffit::ui {
namespace {

constexpr const char* kVertex = R"(#version 150
out vec2 at;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  at = 0.5 * corner + 0.5;
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

// As in DisplayTransform: not a number and negative are black, infinite is the brightest white.
// Alpha tells surfaces from lamps and from what lies beyond (BuildingDrawing). The colours of the
// latter two are render::developPicture()'s.
constexpr const char* kHead = R"(#version 150
in vec2 at;
out vec4 color;
uniform sampler2D source;
uniform float scale;
uniform int false_color;
uniform vec2 range;
uniform int logarithmic;
uniform int difference;
uniform vec3 scale_colors[9];
vec3 cleaned(vec3 c) { return vec3(c.r > 0.0 ? min(c.r, 1.0e6) : 0.0, c.g > 0.0 ? min(c.g, 1.0e6) : 0.0,
                                   c.b > 0.0 ? min(c.b, 1.0e6) : 0.0); }
float place(float lux) {
  if (logarithmic == 0) return clamp((lux - range.x) / (range.y - range.x), 0.0, 1.0);
  return lux <= range.x ? 0.0 : clamp(log(lux / range.x) / log(range.y / range.x), 0.0, 1.0);
}
)";

constexpr const char* kTail = R"(
void main() {
  vec4 pixel = texture(source, at);
  vec3 shown;
  if (difference == 1) {
    float at = place(pixel.a) * 8.0;
    int below = int(min(at, 7.0));
    shown = mix(scale_colors[below], scale_colors[below + 1], at - float(below));
    if (pixel.a < -1.5) shown = vec3(0.13);
    else if (pixel.a < -0.5) shown = vec3(0.55);
  } else if (false_color == 1) {
    shown = soffitView(vec4(vec3(place(pixel.a)), 1.0)).rgb;
    if (pixel.a < -1.5) shown = vec3(0.13);
    else if (pixel.a < -0.5) shown = vec3(0.97);
  } else {
    shown = soffitView(vec4(cleaned(pixel.rgb * scale), 1.0)).rgb;
  }
  color = vec4(clamp(shown, 0.0, 1.0), 1.0);
}
)";

constexpr const char* kCopy = R"(#version 150
in vec2 at;
out vec4 color;
uniform sampler2D source;
uniform float opacity;
void main() { color = vec4(texture(source, at).rgb, opacity); }
)";

bool sameView(const Look& a, const Look& b) {
  if (a.false_color || b.false_color) return a.false_color == b.false_color;
  return a.display.config == b.display.config && a.display.display == b.display.display &&
         a.display.view == b.display.view && a.display.look == b.display.look;
}

}  // namespace

Result<void> DisplayDrawing::setLook(const Look& look) {
  if (!shader_.text.empty() && sameView(look, look_)) {
    look_ = look;
    return {};
  }
  color::DisplayChoice choice = look.display;
  if (look.false_color) {
    choice.view = color::kFalseColorView;
    choice.look.clear();
  }
  auto shader = color::makeDisplayShader(choice);
  if (!shader) return shader.error();
  shader_ = std::move(*shader);
  look_ = look;
  dirty_ = true;
  return {};
}

void DisplayDrawing::build() {
  if (array_ == 0) {
    glGenVertexArrays(1, &array_);
    copy_program_.build(kVertex, kCopy);
    dirty_ = true;
  }
  if (!dirty_) return;
  dirty_ = false;
  program_.build(kVertex, kHead + shader_.text + kTail);
  for (GlTexture& table : tables_) table.release();
  tables_.assign(shader_.tables.size(), {});
  for (std::size_t i = 0; i < tables_.size(); ++i) tables_[i].make(shader_.tables[i]);
}

void DisplayDrawing::drawTriangle() {
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glDepthMask(GL_TRUE);
}

void DisplayDrawing::draw(const GlTarget& scene_linear) {
  build();
  glDisable(GL_BLEND);
  program_.use();
  scene_linear.bindTexture(0);
  program_.set("source", 0);
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    const int unit = static_cast<int>(i) + 1;
    tables_[i].bind(unit);
    program_.set(shader_.tables[i].sampler.c_str(), unit);
  }
  program_.set("scale", color::exposureScale(look_.exposure_ev));
  program_.set("false_color", look_.false_color ? 1 : 0);
  program_.set("range", vec2(dvec2(look_.range.min, look_.range.max)));
  program_.set("logarithmic", look_.range.logarithmic ? 1 : 0);
  program_.set("difference", look_.difference ? 1 : 0);
  // The map is linear between nine colors, evenly spaced from -1 to 1.
  for (int i = 0; look_.difference && i < 9; ++i) {
    const std::string name = "scale_colors[" + std::to_string(i) + "]";
    program_.set(name.c_str(), render::differenceColor(0.25F * static_cast<float>(i) - 1.0F));
  }
  drawTriangle();
}

void DisplayDrawing::copy(const GlTarget& picture, float opacity) {
  build();
  if (opacity < 1.0F) {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
  } else {
    glDisable(GL_BLEND);
  }
  copy_program_.use();
  picture.bindTexture(0);
  copy_program_.set("source", 0);
  copy_program_.set("opacity", opacity);
  drawTriangle();
  glDisable(GL_BLEND);
}

void DisplayDrawing::release() {
  for (GlTexture& table : tables_) table.release();
  tables_.clear();
  program_.release();
  copy_program_.release();
  if (array_ != 0) glDeleteVertexArrays(1, &array_);
  array_ = 0;
}

}  // namespace soffit::ui

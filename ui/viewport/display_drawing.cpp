// SPDX-License-Identifier: MIT
#include <vtk_glew.h>

#include "ui/viewport/display_drawing.h"

#include "core/color/exposure.h"
#include "core/render/difference_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
uniform int steps;
uniform vec3 map_colors[33];
uniform int level_count;
uniform float levels[32];
uniform float line_width;
uniform float lamp;
uniform int blooms;
uniform float bloom_threshold;
uniform float bloom_strength;
uniform sampler2D bloom_spread;
uniform vec2 part_from;
uniform vec2 part_size;
vec3 bloomed(vec3 c) {
  if (blooms == 0) return c;
  float y = dot(c, vec3(0.2126390059, 0.7151686788, 0.0721923154));
  if (y > bloom_threshold) c -= bloom_strength * c * (1.0 - bloom_threshold / y);
  return c + texture(bloom_spread, part_from + at * part_size).rgb;
}
vec3 cleaned(vec3 c) { return vec3(c.r > 0.0 ? min(c.r, 1.0e6) : 0.0, c.g > 0.0 ? min(c.g, 1.0e6) : 0.0,
                                   c.b > 0.0 ? min(c.b, 1.0e6) : 0.0); }
float place(float lux) {
  if (logarithmic == 0) return clamp((lux - range.x) / (range.y - range.x), 0.0, 1.0);
  return lux <= range.x ? 0.0 : clamp(log(lux / range.x) / log(range.y / range.x), 0.0, 1.0);
}
// As color::LuxScale.
vec3 colorAt(float place) {
  float n = float(steps);
  if (steps > 1) place = min(floor(place * n), n - 1.0) / (n - 1.0);
  float x = place * 32.0;
  int below = int(min(x, 31.0));
  return mix(map_colors[below], map_colors[below + 1], x - float(below));
}
// The step of a surface's light to its next pixels along one way. A pixel beyond an edge is told
// by a step that is much larger than the other; where both are the surface's own, their mean.
float slope(float before, float here, float after) {
  float a = before < 0.0 ? 1.0e30 : here - before;
  float b = after < 0.0 ? 1.0e30 : after - here;
  float small = min(abs(a), abs(b));
  float large = max(abs(a), abs(b));
  if (small > 1.0e29) return 0.0;
  return large > 4.0 * small + 1.0e-4 * here ? small : abs(0.5 * (a + b));
}
// x: how far (pixels) the next isolux line is, y: how far the levels about the pixel lie apart, z:
// the level.
vec3 nextLine(float here) {
  ivec2 p = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(source, 0) - 1;
  vec2 g = vec2(slope(texelFetch(source, ivec2(max(p.x - 1, 0), p.y), 0).a, here,
                      texelFetch(source, ivec2(min(p.x + 1, last.x), p.y), 0).a),
                slope(texelFetch(source, ivec2(p.x, max(p.y - 1, 0)), 0).a, here,
                      texelFetch(source, ivec2(p.x, min(p.y + 1, last.y)), 0).a));
  float below = -1.0e30;
  float above = 1.0e30;
  for (int i = 0; i < level_count; ++i) {
    if (levels[i] <= here) below = levels[i];
    else above = min(above, levels[i]);
  }
  float level = here - below < above - here ? below : above;
  // Even light on a level is no line.
  float rise = length(g);
  if (rise < 1.0e-5 * abs(level)) return vec3(1.0e30, 1.0e30, level);
  return vec3(abs(here - level) / rise, (above - below) / rise, level);
}
)";

constexpr const char* kTail = R"(
void main() {
  vec4 pixel = texture(source, at);
  vec3 shown;
  if (false_color == 1) {
    shown = colorAt(place(pixel.a));
    if (pixel.a < -1.5) shown = vec3(0.13);
    else if (pixel.a < -0.5) shown = vec3(lamp);
  } else {
    shown = clamp(soffitView(vec4(cleaned(bloomed(pixel.rgb) * scale), 1.0)).rgb, 0.0, 1.0);
  }
  if (level_count > 0 && pixel.a >= 0.0) {
    vec3 line = nextLine(pixel.a);
    // Lines that would lie on one another fade.
    float room = clamp(0.25 * line.y - 0.75, 0.0, 1.0);
    float cover = room * clamp(0.5 * line_width + 0.5 - line.x, 0.0, 1.0);
    if (false_color == 1) {
      float light = dot(shown, vec3(0.2126, 0.7152, 0.0722));
      shown = mix(shown, light > 0.4 ? vec3(0.05) : vec3(0.95), 0.85 * cover);
    } else {
      float casing = room * clamp(1.1 * line_width + 0.5 - line.x, 0.0, 1.0);
      shown = mix(shown, vec3(0.05), 0.6 * casing);
      shown = mix(shown, colorAt(place(line.z)), cover);
    }
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

/// Lines as wide as the picture asks for: 1.5 pixels on a screen, more in a print.
float lineWidth(int height) {
  return std::max(1.5F, static_cast<float>(height) / 700.0F);
}

/// What an eye adapts to is known from so many pixels.
constexpr std::size_t kEnoughPixels = 120000;
/// Light is spread in a picture of at most about so many pixels: some 20 ms on two cores.
constexpr std::size_t kMostSpread = 300000;

std::vector<vec3> colorsOf(const std::vector<float>& pixels) {
  std::vector<vec3> colors(pixels.size() / 4);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    colors[i] = {pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2]};
  }
  return colors;
}

/// Means of squares of pixels, until they are few.
void shrink(std::vector<vec3>& picture, int& width, int& height) {
  const auto count = static_cast<double>(picture.size());
  const int side = static_cast<int>(std::ceil(std::sqrt(count / kMostSpread)));
  if (side <= 1) return;
  const int columns = (width + side - 1) / side;
  const int rows = (height + side - 1) / side;
  std::vector<vec3> few(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                        vec3(0.0F));
  std::vector<float> shares(few.size(), 0.0F);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto to = static_cast<std::size_t>(y / side * columns + x / side);
      few[to] += picture[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(x)];
      shares[to] += 1.0F;
    }
  }
  for (std::size_t i = 0; i < few.size(); ++i) few[i] /= shares[i];
  picture = std::move(few);
  width = columns;
  height = rows;
}

bool sameView(const Look& a, const Look& b) {
  return a.display.config == b.display.config && a.display.display == b.display.display &&
         a.display.view == b.display.view && a.display.look == b.display.look &&
         color::balanceOf(a.display) == color::balanceOf(b.display);
}

}  // namespace

Result<void> DisplayDrawing::setLook(const Look& look) {
  if (!shader_.text.empty() && sameView(look, look_)) {
    look_ = look;
    return {};
  }
  auto shader = color::makeDisplayShader(look.display);
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

bool DisplayDrawing::learns() const {
  if (look_.false_color) return false;
  return (shader_.adapts && !look_.adapted_to) || look_.bloom.threshold > 0.0;
}

void DisplayDrawing::learn(const GlTarget& scene_linear) {
  blooms_ = false;
  if (look_.adapted_to) adaptation_ = *look_.adapted_to;
  if (!learns()) return;
  std::vector<vec3> picture = colorsOf(scene_linear.read());
  if (!look_.adapted_to) {
    adaptation_ = color::pictureLuminance(picture, picture.size() / kEnoughPixels + 1);
  }
  color::ShaderTable table;
  table.dimensions = 2;
  table.width = scene_linear.width();
  table.height = scene_linear.height();
  shrink(picture, table.width, table.height);
  const auto spread = render::spreadLight(picture, table.width, table.height, look_.bloom);
  if (spread.empty()) return;
  for (const vec3& v : spread) table.values.insert(table.values.end(), {v.x, v.y, v.z});
  spread_.release();
  spread_.make(table);
  blooms_ = true;
}

void DisplayDrawing::setFinish(const Part& part) {
  if (shader_.adapts) {
    const color::PictureLuminance& eye = look_.adapted_to ? *look_.adapted_to : adaptation_;
    const color::ToneOperator tone =
        color::makeToneOperator(*color::toneKindOf(look_.display.view), eye, look_.tone);
    program_.set("soffit_tone", vec2(tone.a, tone.b));
  }
  program_.set("blooms", blooms_ ? 1 : 0);
  if (!blooms_) return;
  const int unit = static_cast<int>(tables_.size()) + 1;
  spread_.bind(unit);
  program_.set("bloom_spread", unit);
  program_.set("bloom_threshold", static_cast<float>(look_.bloom.threshold));
  program_.set("bloom_strength", static_cast<float>(look_.bloom.strength));
  program_.set("part_from", part.from);
  program_.set("part_size", part.size);
}

void DisplayDrawing::draw(const GlTarget& scene_linear, const Part& part) {
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
  setFinish(part);
  program_.set("false_color", look_.false_color ? 1 : 0);
  program_.set("range", vec2(dvec2(look_.scale.range.min, look_.scale.range.max)));
  program_.set("logarithmic", look_.scale.range.logarithmic ? 1 : 0);
  setScale(part.picture_height > 0 ? part.picture_height : scene_linear.height());
  drawTriangle();
}

void DisplayDrawing::setScale(int height) {
  program_.set("lamp", look_.difference ? 0.55F : 0.97F);
  program_.set("steps", look_.difference ? 0 : look_.scale.steps);
  program_.set("line_width", lineWidth(height));
  const auto element = [](const char* name, std::size_t i) {
    return std::string(name) + "[" + std::to_string(i) + "]";
  };
  const bool mapped = look_.false_color || !look_.levels.empty();
  for (std::size_t i = 0; mapped && i < color::kColorMapPoints; ++i) {
    // Differences are linear between nine colors, evenly spaced from -1 to 1: among these, too.
    const float place = static_cast<float>(i) / static_cast<float>(color::kColorMapPoints - 1);
    program_.set(element("map_colors", i).c_str(),
                 look_.difference ? render::differenceColor(2.0F * place - 1.0F)
                                  : color::colorMapAt(look_.scale.map, place));
  }
  const std::size_t count = std::min(look_.levels.size(), color::kMostLevels);
  program_.set("level_count", static_cast<int>(count));
  for (std::size_t i = 0; i < count; ++i) {
    program_.set(element("levels", i).c_str(), static_cast<float>(look_.levels[i]));
  }
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
  spread_.release();
  blooms_ = false;
  program_.release();
  copy_program_.release();
  if (array_ != 0) glDeleteVertexArrays(1, &array_);
  array_ = 0;
}

}  // namespace soffit::ui

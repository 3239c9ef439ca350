// SPDX-License-Identifier: MIT
#include <vtk_glew.h>

#include "ui/viewport/outside_drawing.h"

#include "core/daylight/environment.h"
#include "core/scene/equality.h"

#include <cstddef>
#include <utility>

namespace soffit::ui {
namespace {

// A pixel's ray solves A d ~ (x, y, 1), A the rows of the camera's matrix that give x, y and w:
// neither the eye nor the near plane comes in.
constexpr const char* kOutsideVertex = R"(#version 150
uniform mat4 ray_from_clip;
out vec3 ray;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  ray = mat3(ray_from_clip) * vec3(corner, 1.0);
  gl_Position = vec4(corner, 1.0, 1.0);
}
)";

constexpr const char* kOutsideFragment = R"(#version 150
in vec3 ray;
uniform int pictured;
uniform sampler2D picture;
uniform float turn;
uniform float scale;
uniform int overcast;
uniform vec3 to_sun;
uniform vec3 gradation;
uniform vec3 indicatrix;
uniform float ground;
uniform float sun;
uniform float sun_chord;
uniform float beyond;
out vec4 color;
float sky(vec3 d) {
  if (d.z < 0.0) return ground;
  if (overcast == 1) return gradation.z * (1.0 + 2.0 * d.z) / 3.0;
  float toward = clamp(dot(d, to_sun), -1.0, 1.0);
  float chi = acos(toward);
  float phi = d.z > 0.0 ? 1.0 + gradation.x * exp(gradation.y / d.z) : 1.0;
  return gradation.z * phi * (1.0 + indicatrix.x * (exp(indicatrix.y * chi) -
                              exp(indicatrix.y * 1.5707963267948966)) +
                              indicatrix.z * toward * toward);
}
void main() {
  vec3 d = normalize(ray);
  vec3 light;
  if (pictured == 1) {
    float clockwise = atan(d.x, d.y) + turn;
    light = scale * textureLod(picture, vec2(0.5 + clockwise / 6.283185307179586,
                                             acos(clamp(d.z, -1.0, 1.0)) / 3.141592653589793), 0.0).rgb;
  } else {
    vec3 off = d - to_sun;
    bool covered = sun > 0.0 && dot(off, off) < sun_chord * sun_chord;
    light = vec3(covered ? sun : sky(d));
  }
  color = vec4(light, beyond);
}
)";

constexpr const char* kPaneVertex = R"(#version 150
in vec3 position;
in vec3 normal;
in vec2 slab;
uniform mat4 clip_from_scene;
out vec3 at;
out vec3 facing;
out vec2 sheet;
void main() {
  gl_Position = clip_from_scene * vec4(position, 1.0);
  at = position;
  facing = normal;
  sheet = slab;
}
)";

// daylight::Slab::at().
constexpr const char* kPaneFragment = R"(#version 150
in vec3 at;
in vec3 facing;
in vec2 sheet;
uniform vec3 eye;
uniform int parallel;
out vec4 color;
float through(float face, float pass) {
  float inner = face * pass;
  return (1.0 - face) * (1.0 - face) * pass / max(1.0 - inner * inner, 1.0e-6);
}
void main() {
  vec3 way = normalize(parallel == 1 ? eye : eye - at);
  float ci = clamp(abs(dot(normalize(facing), way)), 1.0e-4, 1.0);
  float n = sheet.x;
  float sine = sqrt(max(0.0, 1.0 - ci * ci)) / n;
  float ct = sqrt(max(1.0e-8, 1.0 - sine * sine));
  float pass = exp(sheet.y / ct);
  float s = (ci - n * ct) / (ci + n * ct);
  float p = (n * ci - ct) / (n * ci + ct);
  color = vec4(vec3(0.5 * (through(s * s, pass) + through(p * p, pass))), 1.0);
}
)";

glm::mat4 rayFromClip(const glm::mat4& clip_from_scene) {
  dmat3 rows(0.0);
  for (int column = 0; column < 3; ++column) {
    rows[column] =
        dvec3(clip_from_scene[column][0], clip_from_scene[column][1], clip_from_scene[column][3]);
  }
  return glm::mat4(glm::mat3(glm::inverse(rows)));
}

}  // namespace

void OutsideDrawing::setEnvironment(const std::optional<scene::Environment>& environment) {
  const bool same = environment_.has_value() == environment.has_value() &&
                    (!environment || scene::same(*environment_, *environment));
  if (same) return;
  const auto picture = look_.picture;
  look_ = environment
              ? OutsideLook::of(*environment, &look_, environment_ ? &*environment_ : nullptr)
              : OutsideLook{};
  environment_ = environment;
  if (look_.picture != picture) picture_dirty_ = true;
}

void OutsideDrawing::setPanes(std::vector<PaneCorner> corners) {
  corners_ = std::move(corners);
  corners_dirty_ = true;
}

void OutsideDrawing::upload() {
  if (!outside_program_.ready()) {
    outside_program_.build(kOutsideVertex, kOutsideFragment);
    pane_program_.build(kPaneVertex, kPaneFragment);
    glGenVertexArrays(1, &pane_array_);
    glGenVertexArrays(1, &empty_array_);
    picture_dirty_ = corners_dirty_ = true;
  }
  if (std::exchange(picture_dirty_, false)) {
    picture_.release();
    if (look_.picture != nullptr) {
      picture_.make(look_.picture->pixels);
      // Round the sphere there is no seam, and at the poles no other side.
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
  }
  if (std::exchange(corners_dirty_, false)) {
    if (corners_.empty()) {
      corner_buffer_.release();
      return;
    }
    glBindVertexArray(pane_array_);
    corner_buffer_.fill(GlBuffer::Kind::vertices, corners_.data(),
                        corners_.size() * sizeof(PaneCorner));
    glBindBuffer(GL_ARRAY_BUFFER, corner_buffer_.id());
    const auto attribute = [](const GLuint location, const GLint size, const std::size_t offset) {
      glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(PaneCorner),
                            reinterpret_cast<const void*>(offset));  // NOLINT: GL's way of offsets
      glEnableVertexAttribArray(location);
    };
    attribute(0, 3, offsetof(PaneCorner, position));
    attribute(4, 3, offsetof(PaneCorner, normal));
    attribute(5, 2, offsetof(PaneCorner, slab));
    glBindVertexArray(0);
  }
}

void OutsideDrawing::setSky(const SkyLook& sky) const {
  outside_program_.set("overcast", sky.overcast ? 1 : 0);
  outside_program_.set("to_sun", sky.to_sun);
  outside_program_.set("gradation", sky.gradation);
  outside_program_.set("indicatrix", sky.indicatrix);
  outside_program_.set("ground", sky.ground);
  outside_program_.set("sun", sky.sun);
  outside_program_.set("sun_chord",
                       static_cast<float>(2.0 * std::sin(0.5 * daylight::Sun::kRadius)));
}

void OutsideDrawing::drawOutside(const glm::mat4& clip_from_scene, float beyond) {
  if (!look_.any()) return;
  upload();
  outside_program_.use();
  outside_program_.set("ray_from_clip", rayFromClip(clip_from_scene));
  outside_program_.set("beyond", beyond);
  outside_program_.set("pictured", look_.picture != nullptr ? 1 : 0);
  outside_program_.set("picture", 0);
  if (look_.sky) {
    setSky(*look_.sky);
  } else {
    outside_program_.set("turn", look_.turn);
    outside_program_.set("scale", look_.scale * look_.picture->unit);
    picture_.bind(0);
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glBindVertexArray(empty_array_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glDepthMask(GL_TRUE);
}

void OutsideDrawing::drawPanes(const glm::mat4& clip_from_scene, const glm::vec4& eye) {
  if (corners_.empty()) return;
  upload();
  pane_program_.use();
  pane_program_.set("clip_from_scene", clip_from_scene);
  pane_program_.set("eye", vec3(eye));
  pane_program_.set("parallel", eye.w == 0.0F ? 1 : 0);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  glBindVertexArray(pane_array_);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
  glBindVertexArray(0);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

void OutsideDrawing::release() {
  picture_.release();
  corner_buffer_.release();
  outside_program_.release();
  pane_program_.release();
  if (pane_array_ != 0) glDeleteVertexArrays(1, &pane_array_);
  if (empty_array_ != 0) glDeleteVertexArrays(1, &empty_array_);
  pane_array_ = empty_array_ = 0;
}

}  // namespace soffit::ui

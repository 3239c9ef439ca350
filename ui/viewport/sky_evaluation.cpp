// SPDX-License-Identifier: MIT
#include <vtk_glew.h>

#include "ui/viewport/sky_evaluation.h"

#include <chrono>

namespace soffit::ui {
namespace {

/// Of a vertex, and of the shader's uniforms, of which OpenGL 3.2 grants 256 of four.
constexpr std::size_t kMostTexels = 96;

/// As SkyVectors packs them: four functions' RGB in three texels.
constexpr const char* kVertex = R"(#version 150
in vec3 lux;  // the rest
uniform samplerBuffer vectors;
uniform int texels;
uniform vec4 weights[96];
out vec4 light;
void main() {
  int first = gl_VertexID * texels;
  vec4 a = vec4(0.0), b = vec4(0.0), c = vec4(0.0);
  for (int t = 0; t < texels; t += 3) {
    a += weights[t] * texelFetch(vectors, first + t);
    b += weights[t + 1] * texelFetch(vectors, first + t + 1);
    c += weights[t + 2] * texelFetch(vectors, first + t + 2);
  }
  vec3 sky = vec3(a.x + a.w + b.z + c.y, a.y + b.x + b.w + c.z, a.z + b.y + c.x + c.w);
  light = vec4(max(lux + sky, vec3(0.0)), 0.0);
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
)";

constexpr const char* kFragment = R"(#version 150
out vec4 color;
void main() { color = vec4(0.0); }
)";

constexpr GLuint kRestAttribute = 2;  // "lux" of GlProgram

}  // namespace

bool SkyEvaluation::fits(const relight::SkyVectors& vectors) const {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  const std::size_t texels = vectors.texels().size();
  return texels > 0 && vectors.texelsPerPoint() <= kMostTexels && texels <= most_ &&
         texels <= static_cast<std::size_t>(most);
}

/// Uploads what is new. False where there is no room.
bool SkyEvaluation::take(const HeldSky& sky) {
  if (array_ == 0) {
    program_.build(kVertex, kFragment, "light");
    glGenVertexArrays(1, &array_);
    glGenTextures(1, &fetch_);
  }
  if (!program_.ready()) return false;
  if (vectors_ != sky.vectors) {
    while (glGetError() != GL_NO_ERROR) {
    }
    vectors_.reset();
    texels_.fill(GlBuffer::Kind::vertices, sky.vectors->texels().data(), sky.vectors->bytes());
    if (glGetError() != GL_NO_ERROR) return false;
    vectors_ = sky.vectors;
    figures_.bytes = sky.vectors->bytes();
  }
  if (rest_ == sky.rest) return true;
  glBindVertexArray(array_);
  rest_buffer_.fill(GlBuffer::Kind::vertices, sky.rest->data(), sky.rest->size() * sizeof(vec3),
                    true);
  glBindBuffer(GL_ARRAY_BUFFER, rest_buffer_.id());
  glVertexAttribPointer(kRestAttribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(kRestAttribute);
  rest_ = sky.rest;
  return true;
}

bool SkyEvaluation::evaluate(const HeldSky& sky, GlBuffer& light) {
  const auto start = std::chrono::steady_clock::now();
  if (!fits(*sky.vectors) || !take(sky)) {
    letGo();
    figures_.where = Figures::Where::refused;
    return false;
  }
  light.reserve(vectors_->points() * sizeof(glm::vec4));
  program_.use();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_BUFFER, fetch_);
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA16F, texels_.id());
  program_.set("vectors", 0);
  program_.set("texels", static_cast<int>(vectors_->texelsPerPoint()));
  program_.set("weights", vectors_->packed(sky.weights));
  glBindVertexArray(array_);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, light.id());
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(vectors_->points()));
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  glBindVertexArray(0);
  glFinish();  // what is drawn next waits for it anyway
  figures_.where = Figures::Where::gpu;
  figures_.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return true;
}

void SkyEvaluation::letGo() {
  texels_.release();
  rest_buffer_.release();
  vectors_.reset();
  rest_.reset();
  figures_ = {};
}

void SkyEvaluation::release() {
  letGo();
  if (array_ != 0) glDeleteVertexArrays(1, &array_);
  if (fetch_ != 0) glDeleteTextures(1, &fetch_);
  array_ = fetch_ = 0;
  program_.release();
}

std::vector<vec3> evaluated(const HeldSky& sky) {
  std::vector<vec3> lux(sky.vectors->points());
  sky.vectors->evaluate(sky.weights, *sky.rest, lux);
  return lux;
}

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#include <vtk_glew.h>

#include "ui/viewport/sky_evaluation.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace soffit::ui {
namespace {

/// Of functions; OpenGL 3.2 grants a vertex shader 256 vectors of uniforms, and a group takes six.
constexpr std::size_t kMostGroups = 36;

/// relight::SkyVectors' formula, as it packs things.
constexpr const char* kTexelVertex = R"(#version 150
in vec3 position;  // the rest: reflected light
in vec3 albedo;    // and direct light
uniform samplerBuffer vectors;
uniform int groups;
uniform vec4 weights[216];
out vec4 light;
void main() {
  int at = 4 * groups * gl_VertexID;
  vec4 a = vec4(0.0), b = vec4(0.0), c = vec4(0.0);
  vec3 direct = albedo;
  for (int g = 0; g < groups; ++g, at += 4) {
    int w = 6 * g;
    a += weights[w] * texelFetch(vectors, at);
    b += weights[w + 1] * texelFetch(vectors, at + 1);
    c += weights[w + 2] * texelFetch(vectors, at + 2);
    vec4 d = texelFetch(vectors, at + 3);
    direct += vec3(dot(weights[w + 3], d), dot(weights[w + 4], d), dot(weights[w + 5], d));
  }
  vec3 reflected = position + vec3(a.x + a.w + b.z + c.y, a.y + b.x + b.w + c.z,
                                   a.z + b.y + c.x + c.w);
  light = vec4(max(max(reflected, vec3(0.0)) + direct, vec3(0.0)), 0.0);
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
)";

constexpr const char* kCornerVertex = R"(#version 150
uniform usamplerBuffer first;
uniform usamplerBuffer slots;
uniform samplerBuffer shares;
uniform samplerBuffer lit;
out vec4 light;
void main() {
  int end = int(texelFetch(first, gl_VertexID + 1).r);
  vec3 sum = vec3(0.0);
  for (int k = int(texelFetch(first, gl_VertexID).r); k < end; ++k) {
    sum += texelFetch(shares, k).r * texelFetch(lit, int(texelFetch(slots, k).r)).rgb;
  }
  light = vec4(max(sum, vec3(0.0)), 0.0);
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
)";

constexpr const char* kNoFragment = R"(#version 150
out vec4 color;
void main() { color = vec4(0.0); }
)";

void bindFetch(int unit, unsigned texture, GLenum format, const GlBuffer& buffer) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_BUFFER, texture);
  glTexBuffer(GL_TEXTURE_BUFFER, format, buffer.id());
}

/// Runs the program that is in use once per point; what it captures goes into `out`.
void capture(unsigned array, std::size_t points, const GlBuffer& out) {
  glBindVertexArray(array);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, out.id());
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(points));
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  glBindVertexArray(0);
}

template <class Values>
std::size_t fill(GlBuffer& buffer, const Values& values) {
  const std::size_t bytes = values.size() * sizeof(values[0]);
  buffer.fill(GlBuffer::Kind::vertices, values.data(), bytes);
  return bytes;
}

}  // namespace

bool SkyEvaluation::fits(const relight::SkyVectors& vectors, const DisplayMesh& mesh) const {
  GLint machine = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &machine);
  const std::size_t most = std::min(most_, static_cast<std::size_t>(machine));
  return vectors.groups() <= kMostGroups && !vectors.texels().empty() && !mesh.slots.empty() &&
         vectors.texels().size() <= most && mesh.slots.size() <= most && mesh.first.size() <= most;
}

void SkyEvaluation::make() {
  if (rest_array_ != 0) return;
  texel_program_.build(kTexelVertex, kNoFragment, "light");
  corner_program_.build(kCornerVertex, kNoFragment, "light");
  glGenVertexArrays(1, &rest_array_);
  glGenVertexArrays(1, &empty_array_);
  for (Fetched* one : {&texels_, &first_, &slots_, &weights_, &lit_}) {
    glGenTextures(1, &one->texture);
  }
}

/// Uploads what is new. False where there is no room.
bool SkyEvaluation::take(const HeldSky& sky, const std::shared_ptr<const DisplayMesh>& mesh) {
  make();
  if (!texel_program_.ready() || !corner_program_.ready()) return false;
  if (vectors_ != sky.vectors || mesh_ != mesh) {
    while (glGetError() != GL_NO_ERROR) {
    }
    const std::size_t lit = sky.vectors->slots() * sizeof(glm::vec4);
    lit_.buffer.reserve(lit);
    figures_.bytes = fill(texels_.buffer, sky.vectors->texels()) +
                     fill(first_.buffer, mesh->first) + fill(slots_.buffer, mesh->slots) +
                     fill(weights_.buffer, mesh->weights) + lit +
                     sky.rest->size() * sizeof(relight::SlotRest);
    if (glGetError() != GL_NO_ERROR) return false;
    vectors_ = sky.vectors;
    mesh_ = mesh;
  }
  if (rest_ != sky.rest) takeRest(sky);
  return true;
}

void SkyEvaluation::takeRest(const HeldSky& sky) {
  constexpr int kStride = sizeof(relight::SlotRest);
  rest_buffer_.fill(GlBuffer::Kind::vertices, sky.rest->data(), sky.rest->size() * kStride, true);
  glBindVertexArray(rest_array_);
  glBindBuffer(GL_ARRAY_BUFFER, rest_buffer_.id());
  const std::array<std::size_t, 2> offsets{offsetof(relight::SlotRest, reflected),
                                           offsetof(relight::SlotRest, direct)};
  for (GLuint i = 0; i < offsets.size(); ++i) {
    glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, kStride,
                          reinterpret_cast<const void*>(offsets[i]));  // NOLINT: GL's offsets
    glEnableVertexAttribArray(i);
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  rest_ = sky.rest;
}

void SkyEvaluation::lightTexels(const HeldSky& sky) {
  texel_program_.use();
  bindFetch(0, texels_.texture, GL_RGBA16F, texels_.buffer);
  texel_program_.set("vectors", 0);
  texel_program_.set("groups", static_cast<int>(vectors_->groups()));
  texel_program_.set("weights", vectors_->packed(sky.weights));
  capture(rest_array_, vectors_->slots(), lit_.buffer);
}

void SkyEvaluation::lightCorners(GlBuffer& light) {
  light.reserve(mesh_->vertexCount() * sizeof(glm::vec4));
  corner_program_.use();
  bindFetch(0, first_.texture, GL_R32UI, first_.buffer);
  bindFetch(1, slots_.texture, GL_R32UI, slots_.buffer);
  bindFetch(2, weights_.texture, GL_R32F, weights_.buffer);
  bindFetch(3, lit_.texture, GL_RGBA32F, lit_.buffer);
  corner_program_.set("first", 0);
  corner_program_.set("slots", 1);
  corner_program_.set("shares", 2);
  corner_program_.set("lit", 3);
  capture(empty_array_, mesh_->vertexCount(), light);
}

bool SkyEvaluation::evaluate(const HeldSky& sky, const std::shared_ptr<const DisplayMesh>& mesh,
                             GlBuffer& light) {
  const auto start = std::chrono::steady_clock::now();
  if (!fits(*sky.vectors, *mesh) || !take(sky, mesh)) {
    letGo();
    figures_.where = Figures::Where::refused;
    return false;
  }
  lightTexels(sky);
  lightCorners(light);
  glFinish();  // what is drawn next waits for it anyway
  figures_.where = Figures::Where::gpu;
  figures_.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return true;
}

void SkyEvaluation::letGo() {
  for (Fetched* one : {&texels_, &first_, &slots_, &weights_, &lit_}) one->buffer.release();
  rest_buffer_.release();
  vectors_.reset();
  mesh_.reset();
  rest_.reset();
  figures_ = {};
}

void SkyEvaluation::release() {
  letGo();
  for (unsigned* array : {&rest_array_, &empty_array_}) {
    if (*array != 0) glDeleteVertexArrays(1, array);
    *array = 0;
  }
  for (Fetched* one : {&texels_, &first_, &slots_, &weights_, &lit_}) {
    if (one->texture != 0) glDeleteTextures(1, &one->texture);
    one->texture = 0;
  }
  texel_program_.release();
  corner_program_.release();
}

std::vector<vec3> evaluated(const HeldSky& sky, const DisplayMesh& mesh) {
  std::vector<vec3> lux(mesh.vertexCount());
  lightVertices(mesh, sky.vectors->evaluate(sky.weights, *sky.rest), lux);
  return lux;
}

}  // namespace soffit::ui

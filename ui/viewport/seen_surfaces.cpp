// SPDX-License-Identifier: MIT
#include <vtk_glew.h>

#include "ui/viewport/seen_surfaces.h"

#include <array>

namespace soffit::ui {
namespace {

constexpr const char* kVertex = R"(#version 150
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

// Weights that are linear on the triangle, not on the screen: with corners (x, y, w) in clip space
// and the pixel p = (x, y, 1), they are as cross(v1, v2).p to cross(v2, v0).p to cross(v0, v1).p
// (Olano and Greer 1997, 2DH rasterization).
constexpr const char* kPlaceFragment = R"(#version 150
uniform usampler2D numbers;
uniform usamplerBuffer indices;
uniform samplerBuffer positions;
uniform mat4 clip_from_scene;
uniform vec2 size;
out uvec4 color;
vec3 corner(uint i) {
  int k = 3 * int(i);
  vec3 p = vec3(texelFetch(positions, k).r, texelFetch(positions, k + 1).r,
                texelFetch(positions, k + 2).r);
  return (clip_from_scene * vec4(p, 1.0)).xyw;
}
void main() {
  uint number = texelFetch(numbers, ivec2(gl_FragCoord.xy), 0).r;
  if (number == 0u) {
    color = uvec4(0xffffffffu);
    return;
  }
  int first = 3 * (int(number) - 1);
  uvec3 at = uvec3(texelFetch(indices, first).r, texelFetch(indices, first + 1).r,
                   texelFetch(indices, first + 2).r);
  vec3 a = corner(at.x), b = corner(at.y), c = corner(at.z);
  vec3 p = vec3(2.0 * gl_FragCoord.xy / size - 1.0, 1.0);
  // Relative to the pixel, or the products of large coordinates cancel.
  a.xy -= p.xy * a.z;
  b.xy -= p.xy * b.z;
  c.xy -= p.xy * c.z;
  vec3 w = vec3(b.x * c.y - b.y * c.x, c.x * a.y - c.y * a.x, a.x * b.y - a.y * b.x);
  float sum = w.x + w.y + w.z;
  w = clamp(sum != 0.0 ? w / sum : vec3(1.0 / 3.0), 0.0, 1.0);
  w /= w.x + w.y + w.z;
  uvec2 q = uvec2(w.xy * 65535.0 + 0.5);
  color = uvec4(at, q.x << 16u | q.y);
}
)";

constexpr const char* kShadeFragment = R"(#version 150
uniform usampler2D corners;
uniform sampler2D albedo;
uniform samplerBuffer light;
uniform vec3 background;
uniform float beyond;
out vec4 color;
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec4 at = texelFetch(corners, pixel, 0);
  if (at.x == 0xffffffffu) {
    color = vec4(background, beyond);
    return;
  }
  float u = float(at.w >> 16u) / 65535.0, v = float(at.w & 0xffffu) / 65535.0;
  vec4 lux = u * texelFetch(light, int(at.x)) + v * texelFetch(light, int(at.y)) +
             (1.0 - u - v) * texelFetch(light, int(at.z));
  color = vec4(texelFetch(albedo, pixel, 0).rgb * lux.rgb * 0.3183098861837907,
               max(dot(lux.rgb, vec3(0.2126390, 0.7151687, 0.0721923)) + lux.a, 0.0));
}
)";

GLuint makeTexture(GLenum inner, GLenum format, GLenum type, int width, int height) {
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(GL_TEXTURE_2D, id);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(inner), width, height, 0, format, type,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return id;
}

void bindFetch(int unit, unsigned texture, GLenum format, unsigned buffer) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_BUFFER, texture);
  glTexBuffer(GL_TEXTURE_BUFFER, format, buffer);
}

void bindPicture(int unit, unsigned texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

}  // namespace

bool SeenSurfaces::fits(const Mesh& mesh) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  return mesh.index_count > 0 && mesh.light != 0 &&
         mesh.index_count <= static_cast<std::size_t>(most) &&
         3 * mesh.vertex_count <= static_cast<std::size_t>(most);
}

void SeenSurfaces::make(int width, int height) {
  if (array_ == 0) {
    glGenVertexArrays(1, &array_);
    glGenTextures(1, &fetch_);
    glGenTextures(1, &fetch_positions_);
    glGenTextures(1, &fetch_light_);
    place_program_.build(kVertex, kPlaceFragment);
    shade_program_.build(kVertex, kShadeFragment);
  }
  if (seen_ != 0 && width == width_ && height == height_) return;
  releaseTargets();
  width_ = width;
  height_ = height;
  numbers_ = makeTexture(GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, width, height);
  albedo_ = makeTexture(GL_RGBA16F, GL_RGBA, GL_FLOAT, width, height);
  corners_ = makeTexture(GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, width, height);
  glGenFramebuffers(1, &seen_);
  glBindFramebuffer(GL_FRAMEBUFFER, seen_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, numbers_, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, albedo_, 0);
  glGenRenderbuffers(1, &depth_);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  const std::array<GLenum, 2> outputs{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glDrawBuffers(2, outputs.data());
  glGenFramebuffers(1, &places_);
  glBindFramebuffer(GL_FRAMEBUFFER, places_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, corners_, 0);
}

void SeenSurfaces::see(const View& view, const Mesh& mesh, const std::function<void()>& draw) {
  make(view.width, view.height);
  glBindFramebuffer(GL_FRAMEBUFFER, seen_);
  const std::array<GLuint, 4> none{};
  const std::array<GLfloat, 4> black{};
  const GLfloat far = 1.0F;
  glDepthMask(GL_TRUE);
  glClearBufferuiv(GL_COLOR, 0, none.data());
  glClearBufferfv(GL_COLOR, 1, black.data());
  glClearBufferfv(GL_DEPTH, 0, &far);
  draw();

  glBindFramebuffer(GL_FRAMEBUFFER, places_);
  glDisable(GL_DEPTH_TEST);
  place_program_.use();
  bindPicture(0, numbers_);
  bindFetch(1, fetch_, GL_R32UI, mesh.indices);
  bindFetch(2, fetch_positions_, GL_R32F, mesh.positions);
  place_program_.set("numbers", 0);
  place_program_.set("indices", 1);
  place_program_.set("positions", 2);
  place_program_.set("clip_from_scene", view.clip_from_scene);
  place_program_.set("size", vec2(view.width, view.height));
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  view_ = view;
}

void SeenSurfaces::shade(unsigned target, const Mesh& mesh, const vec3& background, float beyond) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, seen_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
  glDepthMask(GL_TRUE);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDepthMask(GL_FALSE);
  shade_program_.use();
  bindPicture(0, corners_);
  bindPicture(1, albedo_);
  bindFetch(2, fetch_light_, GL_RGBA32F, mesh.light);
  shade_program_.set("corners", 0);
  shade_program_.set("albedo", 1);
  shade_program_.set("light", 2);
  shade_program_.set("background", background);
  shade_program_.set("beyond", beyond);
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glDepthMask(GL_TRUE);
}

void SeenSurfaces::releaseTargets() {
  for (unsigned* id : {&seen_, &places_}) {
    if (*id != 0) glDeleteFramebuffers(1, id);
    *id = 0;
  }
  for (unsigned* id : {&numbers_, &albedo_, &corners_}) {
    if (*id != 0) glDeleteTextures(1, id);
    *id = 0;
  }
  if (depth_ != 0) glDeleteRenderbuffers(1, &depth_);
  depth_ = 0;
  width_ = height_ = 0;
  forget();
}

void SeenSurfaces::release() {
  releaseTargets();
  for (unsigned* id : {&fetch_, &fetch_positions_, &fetch_light_}) {
    if (*id != 0) glDeleteTextures(1, id);
    *id = 0;
  }
  if (array_ != 0) glDeleteVertexArrays(1, &array_);
  array_ = 0;
  place_program_.release();
  shade_program_.release();
}

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#include <vtk_glew.h>

#include "ui/viewport/gl_objects.h"

#include <glm/gtc/type_ptr.hpp>

#include <array>

namespace soffit::ui {

void GlBuffer::fill(Kind kind, const void* data, std::size_t bytes, bool often) {
  const GLenum target = kind == Kind::vertices ? GL_ARRAY_BUFFER : GL_ELEMENT_ARRAY_BUFFER;
  if (id_ == 0) glGenBuffers(1, &id_);
  glBindBuffer(target, id_);
  if (often && bytes == bytes_) {
    glBufferSubData(target, 0, static_cast<GLsizeiptr>(bytes), data);
  } else {
    glBufferData(target, static_cast<GLsizeiptr>(bytes), data,
                 often ? GL_STREAM_DRAW : GL_STATIC_DRAW);
  }
  bytes_ = bytes;
  if (kind == Kind::vertices) glBindBuffer(target, 0);
}

void GlBuffer::reserve(std::size_t bytes) {
  if (id_ != 0 && bytes == bytes_) return;
  fill(Kind::vertices, nullptr, bytes, false);
}

void GlBuffer::release() {
  if (id_ != 0) glDeleteBuffers(1, &id_);
  id_ = 0;
  bytes_ = 0;
}

void GlProgram::build(const std::string& vertex, const std::string& fragment,
                      const char* captured) {
  release();
  id_ = glCreateProgram();
  std::array<GLchar, 2048> text{};
  const auto add = [&](GLenum kind, const std::string& source) {
    const GLuint shader = glCreateShader(kind);
    const char* code = source.c_str();
    glShaderSource(shader, 1, &code, nullptr);
    glCompileShader(shader);
    glGetShaderInfoLog(shader, static_cast<GLsizei>(text.size()), nullptr, text.data());
    log_ += text.data();
    glAttachShader(id_, shader);
    glDeleteShader(shader);
  };
  log_.clear();
  add(GL_VERTEX_SHADER, vertex);
  add(GL_FRAGMENT_SHADER, fragment);
  const std::array<const char*, 7> inputs{"position", "albedo", "lux",  "uv",
                                          "normal",   "slab",   "gloss"};
  for (GLuint i = 0; i < inputs.size(); ++i) glBindAttribLocation(id_, i, inputs[i]);
  glBindFragDataLocation(id_, 0, "color");
  glBindFragDataLocation(id_, 1, "more");
  if (captured != nullptr) {
    glTransformFeedbackVaryings(id_, 1, &captured, GL_INTERLEAVED_ATTRIBS);
  }
  glLinkProgram(id_);
  GLint linked = GL_FALSE;
  glGetProgramiv(id_, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  glGetProgramInfoLog(id_, static_cast<GLsizei>(text.size()), nullptr, text.data());
  log_ += text.data();
  release();
}

void GlProgram::release() {
  if (id_ != 0) glDeleteProgram(id_);
  id_ = 0;
}

void GlProgram::use() const {
  glUseProgram(id_);
}

int GlProgram::uniform(const char* name) const {
  return glGetUniformLocation(id_, name);
}
void GlProgram::set(const char* name, int value) const {
  glUniform1i(uniform(name), value);
}
void GlProgram::set(const char* name, float value) const {
  glUniform1f(uniform(name), value);
}
void GlProgram::set(const char* name, const vec2& value) const {
  glUniform2fv(uniform(name), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* name, const vec3& value) const {
  glUniform3fv(uniform(name), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* name, const glm::vec4& value) const {
  glUniform4fv(uniform(name), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* name, const glm::mat4& value) const {
  glUniformMatrix4fv(uniform(name), 1, GL_FALSE, glm::value_ptr(value));
}
void GlProgram::set(const char* name, const std::vector<glm::vec4>& values) const {
  glUniform4fv(uniform(name), static_cast<GLsizei>(values.size()), glm::value_ptr(values[0]));
}

void GlTexture::make(const color::ShaderTable& table) {
  release();
  constexpr std::array<GLenum, 3> kTargets{GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D};
  target_ = kTargets[static_cast<std::size_t>(table.dimensions - 1)];
  glGenTextures(1, &id_);
  glBindTexture(target_, id_);
  const GLint filter = table.interpolated ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(target_, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(target_, GL_TEXTURE_MAG_FILTER, filter);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    glTexParameteri(target_, axis, GL_CLAMP_TO_EDGE);
  }
  const GLint inner = table.channels == 1 ? GL_R32F : GL_RGB32F;
  const GLenum format = table.channels == 1 ? GL_RED : GL_RGB;
  const float* values = table.values.data();
  if (table.dimensions == 1) {
    glTexImage1D(target_, 0, inner, table.width, 0, format, GL_FLOAT, values);
  } else if (table.dimensions == 2) {
    glTexImage2D(target_, 0, inner, table.width, table.height, 0, format, GL_FLOAT, values);
  } else {
    glTexImage3D(target_, 0, inner, table.width, table.height, table.depth, 0, format, GL_FLOAT,
                 values);
  }
}

void GlTexture::make(const scene::Image& image) {
  release();
  target_ = GL_TEXTURE_2D;
  glGenTextures(1, &id_);
  glBindTexture(target_, id_);
  glTexParameteri(target_, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(target_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(target_, 0, GL_RGB16F, image.width, image.height, 0, GL_RGB, GL_FLOAT,
               image.pixels.data());
  glGenerateMipmap(target_);
}

void GlTexture::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(target_, id_);
}

void GlTexture::release() {
  if (id_ != 0) glDeleteTextures(1, &id_);
  id_ = 0;
}

namespace {
constexpr std::array<GLint, 4> kLayerInner{GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F};
constexpr std::array<GLenum, 4> kLayerFormat{GL_RED, GL_RG, GL_RGB, GL_RGBA};
}  // namespace

void GlLayers::replace(Format format, int first, int layers, const float* values) {
  glBindTexture(GL_TEXTURE_2D_ARRAY, id_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, first, width_, height_, layers,
                  kLayerFormat.at(static_cast<std::size_t>(format)), GL_FLOAT, values);
}

void GlLayers::fill(Format format, int width, int height, int layers, bool interpolated,
                    const float* values) {
  const auto f = static_cast<std::size_t>(format);
  const bool fits = id_ != 0 && width == width_ && height == height_ && layers == layers_;
  if (!fits) release();
  if (id_ == 0) glGenTextures(1, &id_);
  glBindTexture(GL_TEXTURE_2D_ARRAY, id_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  if (fits) {
    replace(format, 0, layers, values);
    return;
  }
  width_ = width;
  height_ = height;
  layers_ = layers;
  const GLint filter = interpolated ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, filter);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    glTexParameteri(GL_TEXTURE_2D_ARRAY, axis, GL_CLAMP_TO_EDGE);
  }
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, kLayerInner.at(f), width, height, layers, 0,
               kLayerFormat.at(f), GL_FLOAT, values);
}

void GlLayers::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, id_);
}

void GlLayers::release() {
  if (id_ != 0) glDeleteTextures(1, &id_);
  id_ = 0;
}

void GlTarget::resize(int width, int height, Format format) {
  if (framebuffer_ != 0 && width == width_ && height == height_) return;
  release();
  width_ = width;
  height_ = height;
  glGenTextures(1, &color_);
  glBindTexture(GL_TEXTURE_2D, color_);
  const GLint inner = format == Format::display ? GL_RGBA8 : GL_RGBA32F;
  const GLenum type = format == Format::display ? GL_UNSIGNED_BYTE : GL_FLOAT;
  glTexImage2D(GL_TEXTURE_2D, 0, inner, width, height, 0, GL_RGBA, type, nullptr);
  const GLint filter = format == Format::display ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
  if (format == Format::linear_with_depth) {
    glGenRenderbuffers(1, &depth_);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  }
}

void GlTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, width_, height_);
}

void GlTarget::bindTexture(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, color_);
}

void GlTarget::release() {
  if (framebuffer_ != 0) glDeleteFramebuffers(1, &framebuffer_);
  if (color_ != 0) glDeleteTextures(1, &color_);
  if (depth_ != 0) glDeleteRenderbuffers(1, &depth_);
  framebuffer_ = color_ = depth_ = 0;
  width_ = height_ = 0;
}

std::vector<float> GlTarget::read() const {
  std::vector<float> pixels(4 * static_cast<std::size_t>(width_) *
                            static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, pixels.data());
  return pixels;
}

void GlTarget::write(const std::vector<float>& pixels) const {
  const auto wanted = 4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  if (pixels.size() != wanted) return;
  glBindTexture(GL_TEXTURE_2D, color_);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_FLOAT, pixels.data());
}

}  // namespace soffit::ui

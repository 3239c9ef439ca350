// SPDX-License-Identifier: MIT
#pragma once

#include "core/color/display_shader.h"
#include "core/math/vec.h"
#include "core/scene/material.h"

#include <cstddef>
#include <string>
#include <vector>

/// Thin owners of OpenGL objects. All need the context to be current, also when they are released;
/// release() must be called before the context goes. No GL type shows here.
namespace soffit::ui {

/// A vertex or index buffer.
class GlBuffer {
 public:
  enum class Kind { vertices, indices };
  /// Makes room for what is written by OpenGL itself.
  void reserve(std::size_t bytes);
  /// Takes the place of what was there. A buffer that is filled often keeps its storage.
  void fill(Kind kind, const void* data, std::size_t bytes, bool often = false);
  void release();
  [[nodiscard]] unsigned id() const { return id_; }

 private:
  unsigned id_ = 0;
  std::size_t bytes_ = 0;
};

/// A linked program; its fragments write `color` to output 0 and, if they have it, `more` to
/// output 1. Errors of compiling are programming faults: they are told on stderr by VTK's
/// error macro and nothing is drawn.
class GlProgram {
 public:
  /// captured: what the vertex shader gives that is written to a buffer (transform feedback).
  void build(const std::string& vertex, const std::string& fragment,
             const char* captured = nullptr);
  void release();
  void use() const;
  [[nodiscard]] bool ready() const { return id_ != 0; }
  [[nodiscard]] const std::string& log() const { return log_; }
  [[nodiscard]] int uniform(const char* name) const;
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, const vec2& value) const;
  void set(const char* name, const vec3& value) const;
  void set(const char* name, const glm::vec4& value) const;
  void set(const char* name, const glm::mat4& value) const;
  void set(const char* name, const std::vector<glm::vec4>& values) const;

 private:
  unsigned id_ = 0;
  std::string log_;
};

/// A texture.
class GlTexture {
 public:
  void make(const color::ShaderTable& table);
  /// A picture that repeats, with mip-maps.
  void make(const scene::Image& image);
  void bind(int unit) const;
  void release();
  [[nodiscard]] unsigned id() const { return id_; }

 private:
  unsigned id_ = 0;
  unsigned target_ = 0;
};

/// Pictures of one size, one behind the other, floats.
class GlLayers {
 public:
  enum class Format { one, two, three, four };
  /// values: width x height x layers x channels. interpolated: between texels of a layer. Keeps its
  /// storage while size and format stay.
  void fill(Format format, int width, int height, int layers, bool interpolated,
            const float* values);
  /// Some layers anew, from `first` on.
  void replace(Format format, int first, int layers, const float* values);
  [[nodiscard]] int layers() const { return id_ == 0 ? 0 : layers_; }
  void bind(int unit) const;
  void release();

 private:
  unsigned id_ = 0;
  int width_ = 0;
  int height_ = 0;
  int layers_ = 0;
};

/// A picture to draw into.
class GlTarget {
 public:
  enum class Format { linear_with_depth, display, sum };
  /// Nothing happens when it has that size already.
  void resize(int width, int height, Format format);
  void bind() const;
  void bindTexture(int unit) const;
  void release();
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Reads it back, four floats per pixel, the bottom row first.
  [[nodiscard]] std::vector<float> read() const;
  /// Puts a picture into it, as read() gives it. Errors: none; another size is ignored.
  void write(const std::vector<float>& pixels) const;

 private:
  unsigned framebuffer_ = 0;
  unsigned color_ = 0;
  unsigned depth_ = 0;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/color/display_transform.h"

#include <string>
#include <vector>

namespace soffit::color {

/// A table that a shader reads through a sampler uniform.
struct ShaderTable {
  std::string sampler;  ///< the uniform's name
  int dimensions = 1;   ///< 1, 2 or 3: sampler1D, sampler2D, sampler3D
  int width = 1;
  int height = 1;
  int depth = 1;
  int channels = 3;           ///< 1 or 3 floats per entry
  bool interpolated = true;   ///< linear, else nearest; clamped to the edge either way
  std::vector<float> values;  ///< width fastest
};

/// A view transform as a piece of GLSL (version 130 and up).
struct DisplayShader {
  /// Declares what it needs and defines `vec4 soffitView(vec4 color)`: the same function as
  /// DisplayTransform::apply(), up to the precision of the graphics card. Its input must be
  /// finite and not negative; its output is to be clamped to 0..1.
  ///
  /// Of a view that adapts it has the uniform vec2 `soffit_tone`: a and b of the ToneOperator.
  std::string text;
  bool adapts = false;
  std::vector<ShaderTable> tables;
};

/// Errors: as DisplayTransform::create().
Result<DisplayShader> makeDisplayShader(const DisplayChoice& choice);

}  // namespace soffit::color

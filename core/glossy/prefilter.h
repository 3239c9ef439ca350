// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <span>
#include <vector>

/// Weights by which cube maps are blurred with GGX lobes: made once for a size, used by every
/// probe at every move of a light.
namespace soffit::glossy {

/// The texels of a cube map (core/sh/cube_map.h) and, behind them, the means of 2 x 2, 4 x 4 .. of
/// them weighted by solid angle, down to one per face.
class TexelPyramid {
 public:
  /// side: a power of two, 1 .. 512.
  explicit TexelPyramid(int side);

  [[nodiscard]] int side() const { return side_; }
  [[nodiscard]] int levels() const { return static_cast<int>(first_.size()); }
  /// Index of the first texel of a level; level 0 is the map itself.
  [[nodiscard]] std::size_t first(int level) const {
    return first_[static_cast<std::size_t>(level)];
  }
  [[nodiscard]] std::size_t size() const { return solid_angles_.size(); }
  [[nodiscard]] double solidAngle(std::size_t texel) const { return solid_angles_[texel]; }
  [[nodiscard]] const dvec3& direction(std::size_t texel) const { return directions_[texel]; }

  /// values[0 .. 6 side^2) are the map's; the means are written behind. values.size() == size().
  void fill(std::span<vec3> values) const;

 private:
  int side_;
  std::vector<std::size_t> first_;
  std::vector<double> solid_angles_;
  std::vector<dvec3> directions_;
};

/// A cube map of `side` blurred by the reflected GGX lobe of `alpha` about each texel's direction:
/// for every texel of the result a list of texels of a pyramid with weights that sum to 1.
///
/// The lobe, D(half) / 4, is taken at texel centres times exact solid angles; a coarser texel
/// stands for its finer ones where its share of the lobe is too small for their differences to
/// matter. Error against the sum over all finest texels: below 1 % of the map's RMS variation.
class PrefilterLevel {
 public:
  PrefilterLevel(const TexelPyramid& pyramid, int side, double alpha);

  [[nodiscard]] int side() const { return side_; }
  [[nodiscard]] double alpha() const { return alpha_; }
  [[nodiscard]] std::size_t taps() const { return weights_.size(); }

  /// out: 6 side^2 texels. pyramid: TexelPyramid::fill()ed values. On all threads.
  void apply(std::span<const vec3> pyramid, std::span<vec3> out) const;

 private:
  int side_;
  double alpha_;
  std::vector<std::uint32_t> begin_;    ///< per texel and one past the last
  std::vector<std::uint32_t> indices_;  ///< into the pyramid
  std::vector<float> weights_;
};

}  // namespace soffit::glossy

// SPDX-License-Identifier: MIT
#pragma once

#include "core/glossy/prefilter.h"
#include "core/math/vec.h"

#include <memory>
#include <span>
#include <vector>

/// Cube maps of the lit scene at a probe, blurred for every roughness.
namespace soffit::glossy {

/// A cube map that is looked up without seams: bilinear between texel centres, with a rim of the
/// neighbouring faces' texels round each face, so that two faces agree along their edge and three
/// at their corner.
class SmoothCube {
 public:
  SmoothCube() = default;
  /// texels: 6 side^2, layout of core/sh/cube_map.h.
  SmoothCube(int side, std::span<const vec3> texels);
  [[nodiscard]] int side() const { return side_; }
  /// direction: any length above 0.
  [[nodiscard]] vec3 at(const vec3& direction) const;
  /// [face][row][column], side + 2 rows and columns each: what is kept, with the rims.
  [[nodiscard]] std::span<const vec3> rimmed() const { return texels_; }

 private:
  int side_ = 0;
  std::vector<vec3> texels_;  ///< [face][row][column], side + 2 each way
};

/// The sizes and roughnesses of reflection maps, and the weights that make them; shared.
class ReflectionLevels {
 public:
  /// side: of the unblurred map, a power of two from 8. Levels at alpha 0 (the map itself), 0.02
  /// and on by factors of 2^(1/2) to 1; as the lobes grow, the maps shrink, to 8. 64: about 25 MB
  /// of weights, 0.3 s on 2 cores.
  explicit ReflectionLevels(int side);

  [[nodiscard]] const TexelPyramid& pyramid() const { return pyramid_; }
  [[nodiscard]] std::span<const PrefilterLevel> blurred() const { return levels_; }

 private:
  TexelPyramid pyramid_;
  std::vector<PrefilterLevel> levels_;
};

/// A probe's map under one light.
class ReflectionMap {
 public:
  /// radiance: 6 side^2 texels, cd/m2, side = levels->pyramid().side().
  ReflectionMap(std::shared_ptr<const ReflectionLevels> levels, std::span<const vec3> radiance);

  /// Mean of the radiance weighted by the round lobe of `alpha` about `direction` (any length).
  /// Between levels linear in log alpha; below 1/64 toward the unblurred map.
  [[nodiscard]] vec3 at(const vec3& direction, float alpha) const;
  /// The unblurred map and the blurred ones, in ascending order.
  [[nodiscard]] std::span<const SmoothCube> cubes() const { return cubes_; }

  /// The first blurred map's alpha, and how many follow per doubling.
  static constexpr float kSharpest = 1.0F / 64.0F;
  static constexpr int kStepsPerOctave = 2;

 private:
  std::shared_ptr<const ReflectionLevels> levels_;
  std::vector<SmoothCube> cubes_;  ///< the first unblurred
};

}  // namespace soffit::glossy

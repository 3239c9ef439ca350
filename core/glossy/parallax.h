// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/box.h"
#include "core/math/vec.h"

#include <optional>
#include <span>
#include <vector>

/// A cube map is right at its probe alone. Seen from elsewhere, a reflection is looked up toward
/// the place that the reflected ray meets.
namespace soffit::glossy {

/// Distance along the unit direction d to the inside of the box from p in it; nothing from outside.
std::optional<float> distanceToBox(const Box& box, const vec3& p, const vec3& d);

/// Where to look from the probe, and the ratio (distance from p) / (distance from the probe) to the
/// place seen: a lobe of width alpha at p covers what one of alpha times this ratio does there.
struct Lookup {
  vec3 direction{0.0F, 0.0F, 1.0F};  ///< unit
  float width = 1.0F;
};

/// Parallax correction to a room that is a box (Lagarde & Zanuttini 2012): exact for the walls of
/// such a room. From a point outside the box d is returned as it is.
Lookup throughBox(const Box& room, const vec3& probe, const vec3& p, const vec3& d);

/// Where a probe sees the place p + t d.
Lookup seenFrom(const vec3& probe, const vec3& p, const vec3& d, float t);

/// Distances of the scene from a probe in every direction, for what is no box.
///
/// Kept are the inverse depths before the faces, 1/z: between texels they are bilinear, which on a
/// plane is exact (1/z is linear in u and v there) and needs no far end where nothing is (0). Round
/// each face lies a rim of what its neighbours see, so that faces agree along their edges.
class ProbeDepth {
 public:
  /// distances: 6 side^2 along the texels' directions (core/sh/cube_map.h), metres, infinite where
  /// nothing is.
  ProbeDepth(int side, std::span<const float> distances);

  /// Distance along a direction (any length above 0), infinite where nothing is.
  [[nodiscard]] float toward(const vec3& direction) const;

  /// Steps along a ray, which grow as k^(3/2) since what is near is reflected more sharply, and
  /// bisections of the one in which it meets something.
  static constexpr int kSteps = 28;
  static constexpr int kBisections = 6;
  /// What is less behind, as a share of its distance, is on the surface: curves have facets.
  static constexpr float kOnSurface = 0.01F;
  /// m. A ray that is kMostBehind behind so little as kBeyond after it met something passed behind
  /// an edge, where the probe does not see: it goes on.
  static constexpr float kBeyond = 0.05F;
  static constexpr float kMostBehind = 0.25F;

  /// How far the ray p + t d goes until it meets what the probe sees: the distance impostor of
  /// Szirmay-Kalos et al. 2005, by steps along the ray and bisection of the one in which it goes
  /// behind what the probe sees. Where it passes behind an edge nothing is met. far: where to stop
  /// looking, usually distanceToBox(), and the answer where nothing is met. What the probe does not
  /// see counts as free.
  [[nodiscard]] float reach(const vec3& probe, const vec3& p, const vec3& d, float far) const;
  /// seenFrom() at reach().
  [[nodiscard]] Lookup throughDepth(const vec3& probe, const vec3& p, const vec3& d,
                                    float far) const {
    return seenFrom(probe, p, d, reach(probe, p, d, far));
  }

  [[nodiscard]] int side() const { return side_; }
  /// 1/z, 1/m: [face][row][column], side + 2 rows and columns each.
  [[nodiscard]] std::span<const float> rimmed() const { return inverse_; }

 private:
  [[nodiscard]] float& at(int face, int row, int column);
  [[nodiscard]] float bilinear(int face, double u, double v, double least, double most) const;
  int side_;
  std::vector<float> inverse_;
};

}  // namespace soffit::glossy

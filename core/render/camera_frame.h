// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/geometry/ray_caster.h"
#include "core/scene/scene.h"

namespace soffit::render {

/// A pinhole camera over a picture of some size: pixels to rays and back.
///
/// Picture coordinates have (0, 0) at the top left corner, x to the right, y down; the pixel
/// (i, j) covers [i, i+1) x [j, j+1). Upright means world z; a camera that looks straight up or
/// down has +y at the picture's top (looking down) or bottom (looking up).
class CameraFrame {
 public:
  /// `origin` is subtracted from the camera's world position (Mesh::origin).
  /// Errors: numbers that are not finite, target at the position, field of view outside
  /// 0.1..179 degrees, a side of 0 or above 32768 pixels.
  static Result<CameraFrame> create(const scene::Camera& camera, int width, int height,
                                    const dvec3& origin = dvec3(0.0));

  /// The ray through a place of the picture; unit direction, t_min = 0.
  [[nodiscard]] geometry::Ray ray(double x, double y) const;

  /// Where a point (relative to the origin) appears. z is its depth along the view axis in
  /// metres; at or behind the camera z <= 0 and x, y mean nothing.
  [[nodiscard]] dvec3 project(const dvec3& point) const;

  /// Angle of a pixel at the picture's centre, rad: a pixel at distance d is about d times this.
  [[nodiscard]] double pixelAngle() const { return pixel_angle_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  dvec3 position_{0.0};
  dvec3 forward_{1.0, 0.0, 0.0};
  dvec3 right_{0.0};
  dvec3 up_{0.0};
  double half_height_ = 1.0;  // tan(fov / 2)
  double pixel_angle_ = 0.0;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace soffit::render

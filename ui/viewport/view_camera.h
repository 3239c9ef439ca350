// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/box.h"
#include "core/math/vec.h"
#include "core/scene/scene.h"

namespace soffit::ui {

/// The eye of a view and how the mouse moves it. World coordinates, z stays up.
///
/// Pixels are logical or physical alike, as long as width and height agree; (0, 0) is the top left.
struct ViewCamera {
  dvec3 position{4.0, -6.0, 3.0};
  dvec3 forward{0.0, 1.0, 0.0};  ///< unit, never straight up or down
  double vertical_fov = 0.87;    ///< rad

  /// From a saved camera; one that looks straight up or down is tilted by a hair.
  static ViewCamera from(const scene::Camera& camera);
  /// The camera as a project saves it; the target lies `distance` m ahead.
  [[nodiscard]] scene::Camera toScene(const std::string& name, double distance = 3.0) const;

  [[nodiscard]] dvec3 right() const;
  [[nodiscard]] dvec3 up() const;
  /// Direction through a pixel, unit.
  [[nodiscard]] dvec3 rayThrough(const dvec2& pixel, const dvec2& size) const;
  /// Where a point appears; z is its depth along the view axis, m.
  [[nodiscard]] dvec3 project(const dvec3& point, const dvec2& size) const;
  /// Metres per pixel, up and down, at a depth.
  [[nodiscard]] double pixelSize(double depth, const dvec2& size) const;

  /// Turns about a point: yaw about z, pitch about the horizontal, rad. Stops short of the poles.
  void orbit(const dvec3& pivot, double yaw, double pitch);
  /// Turns the eye on the spot.
  void look(double yaw, double pitch) { orbit(position, yaw, pitch); }
  /// Moves along the picture plane so that what lies at `depth` follows the mouse.
  void pan(const dvec2& pixels, double depth, const dvec2& size);
  /// Goes toward a point, which keeps its place in the picture: 0.5 halves the distance to it.
  void approach(const dvec3& point, double factor);
  /// Goes back or forth until the box fills the picture.
  void frame(const Box& box, const dvec3& origin, double aspect);
};

}  // namespace soffit::ui

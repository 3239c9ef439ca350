// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/box.h"
#include "core/math/vec.h"
#include "core/scene/scene.h"

namespace soffit::ui {

/// The eye of a view and how the mouse moves it. World coordinates, z stays up.
///
/// In perspective, or in parallel along one of the world's axes: plans, elevations and sections. A
/// parallel view stands before all that it shows; `position` is the middle of its picture.
///
/// Pixels are logical or physical alike, as long as width and height agree; (0, 0) is the top left.
struct ViewCamera {
  dvec3 position{4.0, -6.0, 3.0};
  dvec3 forward{0.0, 1.0, 0.0};  ///< unit; straight up or down in parallel views alone
  double vertical_fov = 0.87;    ///< rad
  double parallel_height = 0.0;  ///< m from the picture's bottom to its top; 0: perspective
  double cut_depth = 0.0;        ///< m ahead; a parallel view cuts away what is nearer; 0: nothing

  bool operator==(const ViewCamera&) const = default;

  /// From a saved camera; one that looks straight up or down is tilted by a hair.
  static ViewCamera from(const scene::Camera& camera);
  /// The camera as a project saves it; the target lies `distance` m ahead.
  [[nodiscard]] scene::Camera toScene(const std::string& name, double distance = 3.0) const;

  [[nodiscard]] bool isParallel() const { return parallel_height > 0.0; }
  [[nodiscard]] dvec3 right() const;
  [[nodiscard]] dvec3 up() const;
  /// Direction through a pixel, unit.
  [[nodiscard]] dvec3 rayThrough(const dvec2& pixel, const dvec2& size) const;
  /// Where the ray through a pixel begins: at the eye, or before it in the plane of the picture.
  [[nodiscard]] dvec3 rayOrigin(const dvec2& pixel, const dvec2& size) const;
  /// Where the line of sight to a point begins, and its direction, unit.
  [[nodiscard]] dvec3 eyeFor(const dvec3& point) const;
  [[nodiscard]] dvec3 sightTo(const dvec3& point) const;
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
  /// Goes back or forth until the box fills the picture; a parallel view keeps its cut.
  void frame(const Box& box, const dvec3& origin, double aspect);

  /// The world's axis that a parallel view looks along, 0..2.
  [[nodiscard]] int mainAxis() const;
  /// Where the cut is on that axis, m; it does not go behind the picture.
  [[nodiscard]] double cutPlace() const;
  void setCutPlace(double metres);

 private:
  void frameParallel(const Box& box, const dvec3& origin, double aspect);
};

}  // namespace soffit::ui

// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/scene/material.h"

#include <memory>
#include <string>
#include <variant>

/// What surrounds a building, as the project says it; `daylight` computes with it.
namespace soffit::scene {

/// A CIE standard sky (1..16), the sun and the ground (interfaces.md, Sky).
struct Sky {
  int cie = 1;
  double sun_azimuth_deg = 180.0;  ///< from +y clockwise seen from above
  double sun_altitude_deg = 45.0;
  double horizontal_illuminance = 0.0;     ///< lx, of the sky alone
  double direct_normal_illuminance = 0.0;  ///< lx, of the sun's disc; 0: none
  double ground_reflectance = 0.0;
};

enum class ProbeLayout { lat_long, angular, cross };

/// A picture of the surroundings; its centre looks to +y.
struct Probe {
  std::string file;  ///< relative to the project
  ProbeLayout layout = ProbeLayout::lat_long;
  double rotation_deg = 0.0;  ///< counter-clockwise seen from above
  double scale = 1.0;         ///< cd/m^2 per unit of the picture
  std::shared_ptr<const Image> image;
};

/// The tutorial's light without a photograph (core/sh/analytic_light.h): a patch overhead and one
/// on the horizon.
struct PatchLight {
  double overhead_gain = 5.0;
  double overhead_threshold = 4.0;
  double side_gain = 4.0;
  double side_threshold = 3.0;
  double side_azimuth_rad = 2.5;  ///< from +x towards +y
  double rotation_deg = 0.0;      ///< counter-clockwise seen from above
  double scale = 1.0;             ///< cd/m^2 per unit of the formula
};

struct Environment {
  std::string description;  ///< one line for reports
  std::variant<Sky, Probe, PatchLight> light;
};

}  // namespace soffit::scene

// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/scene/environment.h"
#include "core/scene/material.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

/// What the viewport needs to draw surroundings and panes: numbers for shaders, no GL. The same
/// radiance as daylight::Environment, the same glass as daylight::Slab.
namespace soffit::ui {

/// A standard sky, its sun and the ground, cd/m^2: unit (1 + a exp(b / z)) f(chi) above the
/// horizon, or unit (1 + 2 z) / 3 where `overcast` says so.
struct SkyLook {
  bool overcast = false;  ///< type 16
  vec3 to_sun{0.0F, 0.0F, 1.0F};
  vec3 gradation{0.0F};   ///< a, b, and the unit
  vec3 indicatrix{0.0F};  ///< c, d, e
  float ground = 0.0F;
  float sun = 0.0F;  ///< of the disc; 0: none
};

/// A picture all round, in its own axes: lat-long, +z at the top, +y in the middle, columns
/// clockwise seen from above.
struct RoundPicture {
  scene::Image pixels;  ///< three channels; largest value 1
  float unit = 1.0F;    ///< what 1 is
};

/// Surroundings as they are drawn.
struct OutsideLook {
  std::optional<SkyLook> sky;
  std::shared_ptr<const RoundPicture> picture;
  float turn = 0.0F;   ///< of the picture, radians counter-clockwise seen from above
  float scale = 1.0F;  ///< of the picture, cd/m^2 per unit of its source

  /// before: surroundings whose picture is taken over where it is the same one.
  static OutsideLook of(const scene::Environment& environment, const OutsideLook* before,
                        const scene::Environment* before_environment);
  [[nodiscard]] bool any() const { return sky.has_value() || picture != nullptr; }
};

/// Corners of a scene's glass, three per triangle.
struct PaneCorner {
  vec3 position{0.0F};
  vec3 normal{0.0F};
  vec2 slab{1.0F,
            0.0F};  ///< index, ln of what one pass through it at normal incidence lets through
};
std::vector<PaneCorner> paneCorners(const geometry::Mesh& mesh,
                                    std::span<const scene::Material> materials);

}  // namespace soffit::ui

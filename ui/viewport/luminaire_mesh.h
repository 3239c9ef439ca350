// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "ui/viewport/emitter_set.h"

#include <span>
#include <vector>

namespace soffit::ui {

/// The surfaces of luminaires as triangles, wound toward the side that is seen, with the luminance
/// that each corner sends to the eye. Curved shapes are inscribed.
struct LuminaireMesh {
  struct Vertex {
    vec3 position{0.0F};  ///< scene-local
    vec3 radiance{0.0F};  ///< linear Rec.709, cd/m^2
  };
  std::vector<Vertex> triangles;  ///< three in a row
};

/// eye: scene-local. Sides that give no light are there (black) with casts_shadow alone, or when
/// the luminaire is off; points are not. left_out: per luminaire; empty: none.
LuminaireMesh makeLuminaireMesh(const EmitterSet& set, const vec3& eye,
                                const std::vector<bool>& left_out = {});

/// The edges that outline a luminaire, two ends in a row: what a selection is drawn with. A point
/// gets a small cross.
std::vector<vec3> outlineOf(const light::Emitter& emitter);

}  // namespace soffit::ui

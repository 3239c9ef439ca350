// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/math/vec.h"

#include <cstddef>
#include <span>
#include <vector>

namespace soffit::render {

/// A piece of surface that reflects.
struct ReflectingPiece {
  vec3 position{0.0F};
  vec3 normal{0.0F, 0.0F, 1.0F};  ///< unit
  float area = 0.0F;              ///< m^2
};

/// Where probes stand: before surfaces that reflect, so that they see what is reflected there, and
/// nowhere else. Candidates are 1.2 m before pieces (half way, where something is nearer than
/// 2.4 m); one after another is taken that sees the most surface within 4 m that none does yet,
/// until `most` are there or 1 % is left; then the same for what only one sees. Candidates from
/// which hardly more than the void is seen are none, unless the void shines (`sky`).
///
/// pieces: of all that reflects; some hundred of them, drawn evenly by area, decide. All in the
/// caster's frame. Deterministic.
std::vector<vec3> probePlaces(const geometry::RayCaster& caster,
                              std::span<const ReflectingPiece> pieces, std::size_t most, bool sky);

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/direct_stage.h"
#include "core/light/emitter.h"
#include "core/transfer/operators.h"

#include <span>
#include <vector>

/// Luminaires with casts_shadow: black bodies that move.
namespace soffit::relight {

/// The body's surface as blockers: flat shapes as they are (both sides block), spheres and tubes
/// tessellated with the same silhouette area, meshes by their triangles. Empty without
/// casts_shadow.
std::vector<light::MaskBlocker> bodyBlockers(const light::Emitter& emitter);

/// The box about blockers; empty without any.
Box boxOf(std::span<const light::MaskBlocker> blockers);

/// Multiplies open[slot] by the share of each texel that a flat body hugging its surface leaves
/// free (gap under a tenth of the body's size): what lies behind it neither gets nor gives light.
void coverTexels(const light::Emitter& emitter, const transfer::Texels& texels,
                 std::span<float> open);

/// open[slot] of the bodies of all these luminaires; empty when none casts shadows.
std::vector<float> openShare(std::span<const light::Emitter> emitters,
                             const transfer::Texels& texels);

}  // namespace soffit::relight

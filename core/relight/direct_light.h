// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/direct_stage.h"
#include "core/transfer/static_scene.h"

#include <cstdint>
#include <span>

namespace soffit::relight {

/// light::directIlluminance() in a scene, through its glass: without glass, exactly that and no
/// more.
///
/// With glass, E = E_1 + (E_0 - E_1) tau: E_0 as if there were no glass, E_1 with the panes as
/// blockers (the same bits of the light, so that what does not come through glass cancels exactly),
/// tau the transmittance of the sheets on the way, averaged over points of the light that are seen
/// through glass, weighted as the light is. Only clusters whose box, joined with the light's, meets
/// a pane's are computed twice. tau is smooth over the light; 16 points leave below 1e-3 of E
/// unless the light is within its own size of the receiver at grazing incidence on the pane.
///
/// lux, lit, changed, counts: as directIlluminance() has them.
void directLight(const transfer::StaticScene& scene, const light::PreparedLight& light,
                 const light::Receivers& receivers, std::span<const light::MaskBlocker> bodies,
                 std::span<float> lux, std::span<std::uint8_t> lit,
                 light::DirectCounts* counts = nullptr, std::span<const Box> changed = {});

}  // namespace soffit::relight

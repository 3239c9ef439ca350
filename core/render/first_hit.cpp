// SPDX-License-Identifier: MIT
#include "core/render/first_hit.h"

#include <algorithm>

namespace soffit::render {

void traceFirst(const ViewScene& scene, std::span<const geometry::Ray> rays,
                const TraceHints& hints, std::span<geometry::Hit> scratch,
                std::span<FirstHit> out) {
  scene.caster().closest(rays, scratch, hints.coherent);
  const EmitterHits& emitters = scene.emitterHits();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const geometry::Hit& hit = scratch[i];
    out[i] = {hit, {}};
    if (!hints.luminaires || emitters.empty()) continue;
    geometry::Ray reach = rays[i];
    if (hit.valid()) reach.t_max = hit.t + std::max(5.0e-4F, 1.0e-4F * hit.t);
    out[i].emitter = emitters.closest(reach);
    if (out[i].emitter.valid()) out[i].surface = {};
  }
}

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#include "core/render/first_hit.h"

#include <algorithm>
#include <vector>

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
  if (scene.panes() == nullptr) return;
  std::vector<geometry::Ray> ways(rays.begin(), rays.end());
  std::vector<float> through(rays.size(), 1.0F);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    if (out[i].surface.valid()) ways[i].t_max = out[i].surface.t;
    if (out[i].emitter.valid()) ways[i].t_max = out[i].emitter.t;
  }
  scene.panes()->attenuate(ways, through);
  for (std::size_t i = 0; i < ways.size(); ++i) out[i].through = through[i];
}

}  // namespace soffit::render

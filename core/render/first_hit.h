// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/render/emitter_hits.h"
#include "core/render/view_scene.h"

#include <span>

namespace soffit::render {

/// What a ray meets first.
struct FirstHit {
  geometry::Hit surface;  ///< valid where a surface is first
  EmitterHit emitter;     ///< valid where a luminaire is first
  float through = 1.0F;   ///< share of its light that comes through the glass before it
};

/// What traceFirst() may rely on.
struct TraceHints {
  bool coherent = false;   ///< neighbouring rays run side by side
  bool luminaires = true;  ///< false: none can be met
};

/// Traces rays (unit directions) against surfaces in packets and against luminaires. A luminaire
/// that lies in a surface, within 0.5 mm or 1e-4 of the distance, is in front of it.
/// `scratch` and `out` are as long as `rays`.
void traceFirst(const ViewScene& scene, std::span<const geometry::Ray> rays,
                const TraceHints& hints, std::span<geometry::Hit> scratch, std::span<FirstHit> out);

}  // namespace soffit::render

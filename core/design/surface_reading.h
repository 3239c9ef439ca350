// SPDX-License-Identifier: MIT
#pragma once

#include "core/design/surface_receivers.h"
#include "core/relight/lighting.h"

#include <span>
#include <vector>

namespace soffit::design {

/// The interactive solution at points of surfaces, RGB lux, the way pictures show it: direct light
/// evaluated at the point itself, indirect light interpolated between the texels around it on
/// its own surface.
///
/// All luminaires of `lighting` that are on, bodies included.
std::vector<relight::SensorLight> readSurfaces(const relight::Lighting& lighting,
                                               std::span<const SurfaceReceiver> receivers);

/// The part of it that is interpolated: planes of RGB values per slot at points of surfaces.
std::vector<dvec3> interpolateAt(const transfer::Texels& texels, const relight::Planes& planes,
                                 std::span<const SurfaceReceiver> receivers);

/// The receivers in the form that direct light takes them, clusters of at most 64.
light::Receivers toReceivers(std::span<const SurfaceReceiver> receivers);

/// What blocks the light of luminaire i: the bodies of all others, and its own if it is a mesh.
std::vector<light::MaskBlocker> bodiesAgainst(std::span<const light::Emitter> emitters,
                                              std::size_t i);

}  // namespace soffit::design

// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/static_scene.h"
#include "core/transfer/texels.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soffit::transfer {

/// Where cosine-distributed rays from a point end.
struct HemisphereHits {
  std::vector<std::uint32_t> slots;  ///< texel per ray; kNoTexel where the ray misses or ends inside
  int missed = 0;                    ///< rays that left the scene
  int inside = 0;                    ///< rays that met the inside of a closed solid
};

/// Scratch memory for traceHemisphere.
struct HemisphereScratch {
  std::vector<geometry::Ray> rays;
  std::vector<geometry::Hit> hits;
};

/// Traces side*side rays, stratified and jittered in the cosine-weighted hemisphere about n
/// (Shirley & Chiu map), rotated at random per point: E = pi/N sum L for any radiance L, error
/// O(N^-3/4) for piecewise smooth ones. Every ray carries the same weight.
///
/// Where fewer than one ray in 128 meets the scene, all count as having left it: light that reaches
/// its outside through a seam would be a leak, and what is lost comes from less than 1 % of the hemisphere.
///
/// A sheet of glass lets a ray through, mirrors it or swallows it by chance, with the probabilities
/// of its transmittance and reflectance: the weights stay equal, what a pane mirrors is seen in it.
/// What is swallowed counts as having left the scene.
///
/// p, n           scene-local, n unit.
/// gap            m, Texels::gapReach of the point's texel: rays that end nearer on a texel outside of
///                gaps count as dark.
/// seed           decides jitter and rotation; equal seeds give equal rays.
void traceHemisphere(const StaticScene& scene, const Texels& texels, const vec3& p, const vec3& n, int side,
                     std::uint64_t seed, float gap, HemisphereScratch& scratch, HemisphereHits& out);

}  // namespace soffit::transfer

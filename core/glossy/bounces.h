// SPDX-License-Identifier: MIT
#pragma once

#include "core/glossy/first_hits.h"
#include "core/glossy/receiver_blocks.h"

#include <span>
#include <vector>

/// Light that reaches glossy receivers inside a room, as coefficients of its direction.
///
/// Indoors light does not come from afar: what arrives at a receiver is what the surfaces that it
/// sees send out. Projected over the receiver's own first hits this is M L already, visibility
/// included, and the lobe can be applied to it (matrix_set.h, shade()).
namespace soffit::glossy {

/// Coefficients of the light that arrives at every receiver, 3 n^2 rows each: sum of w L y over the
/// directions. bands in 1 .. 6. Receivers in parallel; `light` is called from any thread.
/// Error: that of the directions, for N Hammersley directions about 2 / sqrt(N) of the jumps in L.
FloatBlocks arrivingLight(const FirstHits& receivers, const HitRadiance& light, int bands);

/// The same with radiance by source: source_of[r * directions + k]. A gather without rays.
FloatBlocks arrivingLight(const FirstHits& receivers, std::span<const std::uint32_t> source_of,
                          std::span<const vec3> radiance, int bands);

/// Surfaces that light each other: every receiver is a source as well.
struct BounceSurfaces {
  const FirstHits& receivers;                ///< with normals
  std::span<const vec3> normals;             ///< unit, per receiver
  std::span<const std::uint32_t> source_of;  ///< per receiver and direction: which receiver is seen
  std::span<const vec3> reflectance;         ///< diffuse, per receiver
};

/// Fixed light: arriving light after 1, 2, .. `bounces` diffuse reflections on its way, a set of
/// coefficients per bounce, so that one lookup per bounce shows it from any eye (the one- and
/// two-bounce textures of Dhawal et al. 2022). `direct`: illuminance, lux RGB, per receiver. The
/// irradiance that goes on to the next bounce is summed over the directions by the cosine, not from
/// the coefficients. What is left out after k bounces is rho^(k+1) of the light (numerics.md § 3).
std::vector<FloatBlocks> bounceTextures(const BounceSurfaces& surfaces,
                                        std::span<const vec3> direct, int bounces, int bands);

}  // namespace soffit::glossy

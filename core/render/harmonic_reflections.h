// SPDX-License-Identifier: MIT
#pragma once

#include "core/glossy/receiver_blocks.h"
#include "core/render/illumination.h"
#include "core/render/sent_albedo.h"
#include "core/render/surface_sample.h"
#include "core/render/view_scene.h"
#include "core/sh/sphere_samples.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

/// Reflections of the lit room by spherical harmonics (core/glossy): what arrives at receivers as
/// coefficients, seen through the lobes of samples near them.
namespace soffit::render {

/// "No receiver": a sample that gets no light by this way.
inline constexpr std::uint32_t kNoReceiver = 0xffffffffU;

/// Light of surfaces at receivers, 3 bands^2 rows each (glossy::arrivingLight()); what is seen
/// shows SentAlbedo times the illumination. positions, normals: equally many; bands in 1 .. 6.
glossy::FloatBlocks arrivingAt(const ViewScene& scene, const SentAlbedo& sent,
                               const Illumination& illumination, std::span<const vec3> positions,
                               std::span<const vec3> normals,
                               const std::shared_ptr<const sh::SphereSamples>& directions,
                               int bands);

/// What each sample's lobe reflects of the light at its receiver toward the eye, cd/m2, never
/// negative. bands: at most those of `arriving`. receiver_of: per sample, or kNoReceiver.
std::vector<vec3> throughLobes(const ViewScene& scene, const glossy::FloatBlocks& arriving,
                               int bands, std::span<const SurfaceSample> samples,
                               std::span<const std::uint32_t> receiver_of);

}  // namespace soffit::render

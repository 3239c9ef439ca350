// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/reference/reference_scene.h"
#include "core/reference/tracer.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// What an eye sees of surfaces along lines of sight, by path tracing: the judge of pictures.
namespace soffit::reference {

/// Radiance of surfaces (luminaires that are looked at left out), cd/m2 linear Rec.709, by two
/// independent halves of the paths: the mean product of their errors against some other picture is
/// the square of that picture's error, free of the noise of either.
struct BeamEstimate {
  std::array<dvec3, 2> halves{};
  /// Of that, light that comes straight from luminaires and surroundings to the surface seen.
  std::array<dvec3, 2> direct{};
  [[nodiscard]] dvec3 mean() const { return 0.5 * (halves[0] + halves[1]); }
};

struct BeamOptions {
  std::uint32_t paths = 1024;  ///< per half; best a power of two
  std::uint64_t seed = 1;
};

/// Beams in world coordinates. Unbiased; the same numbers on any number of threads. When cancelled,
/// the rest is 0.
std::vector<BeamEstimate> traceBeams(const ReferenceScene& scene, std::span<const Beam> beams,
                                     const BeamOptions& options, const Job& job = {});

}  // namespace soffit::reference

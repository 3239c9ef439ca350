// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/math/vec.h"
#include "core/sh/sphere_samples.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

/// What probes and receivers see of the static scene: found once, lit again and again.
namespace soffit::glossy {

/// The first hits of rays from some points along common directions. Light moves, walls do not: a
/// new light takes no ray, only the light at these hits.
class FirstHits {
 public:
  /// Casts from every position (the caster's frame). normals: empty for probes, which look all
  /// round; else unit, equally many: rays start offset along them and directions below the surface
  /// are left out (their hit is invalid). Positions in parallel.
  FirstHits(const geometry::RayCaster& scene, std::span<const vec3> positions,
            std::span<const vec3> normals, std::shared_ptr<const sh::SphereSamples> samples);

  [[nodiscard]] std::size_t size() const { return positions_.size(); }
  [[nodiscard]] const sh::SphereSamples& samples() const { return *samples_; }
  [[nodiscard]] const vec3& position(std::size_t i) const { return positions_[i]; }
  /// One per direction.
  [[nodiscard]] std::span<const geometry::Hit> hits(std::size_t i) const {
    return std::span(hits_).subspan(i * samples_->size(), samples_->size());
  }
  /// Whether a direction is above the surface of a receiver; always for a probe.
  [[nodiscard]] bool above(std::size_t i, std::size_t direction) const {
    return normals_.empty() || glm::dot(vec3(samples_->directions[direction]), normals_[i]) > 0.0F;
  }
  [[nodiscard]] std::size_t bytes() const { return hits_.size() * sizeof(geometry::Hit); }

 private:
  std::shared_ptr<const sh::SphereSamples> samples_;
  std::vector<vec3> positions_, normals_;
  std::vector<geometry::Hit> hits_;
};

/// The light that comes back along rays, cd/m2: rays[k] met hits[k] (valid), radiance[k] is wanted.
/// For diffuse surfaces albedo (E_direct + E_indirect) / pi. Thread-safe.
using HitRadiance =
    std::function<void(std::span<const geometry::Ray> rays, std::span<const geometry::Hit> hits,
                       std::span<vec3> radiance)>;

/// Radiance along all directions of point i; what meets nothing or lies below is `background`.
std::vector<vec3> lightHits(const FirstHits& first, std::size_t i, const HitRadiance& light,
                            const vec3& background = vec3(0.0F));

/// "No source": a direction that meets nothing, or what has no radiosity.
inline constexpr std::uint32_t kNoSource = 0xffffffffU;

/// Radiance from a table of sources (texels of the light engine, say) by the source of each
/// direction: the fastest way to light a probe again. values in cd/m2.
std::vector<vec3> gatherSources(std::span<const std::uint32_t> source_of,
                                std::span<const vec3> values);

}  // namespace soffit::glossy

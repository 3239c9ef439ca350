// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

namespace soffit::geometry {

inline constexpr std::uint32_t kNoTriangle = 0xffffffffU;

/// A ray segment: origin + t direction, t in [t_min, t_max]; direction need not be unit.
struct Ray {
  vec3 origin{0.0F};
  float t_min = 0.0F;
  vec3 direction{0.0F, 0.0F, 1.0F};
  float t_max = std::numeric_limits<float>::infinity();
};

/// The nearest intersection: the triangle's index, its distance along the ray, and barycentric
/// coordinates (point = (1-u-v) a + u b + v c).
struct Hit {
  std::uint32_t triangle = kNoTriangle;
  float t = std::numeric_limits<float>::infinity();
  float u = 0.0F;
  float v = 0.0F;
  [[nodiscard]] bool valid() const { return triangle != kNoTriangle; }
};

/// Static acceleration structure over triangles (Embree 3 or 4 behind it). Both sides of every
/// triangle are hit. Immutable after construction and safe to use from any thread.
///
/// Rays that start on a surface must be offset by the caller: offsetOrigin().
class RayCaster {
 public:
  /// Copies what it needs. An empty list of triangles is legal: nothing is ever hit.
  RayCaster(std::span<const vec3> positions, std::span<const uvec3> triangles);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  [[nodiscard]] Hit closest(const Ray& ray) const;
  [[nodiscard]] bool occluded(const Ray& ray) const;

  /// Many rays at once, in packets of 16; coherent rays next to one another are fastest.
  /// hits.size() == rays.size().
  /// coherent: neighbours start together and run side by side (a picture's primary rays); that
  /// halves the time of a picture. The hits are the same.
  void closest(std::span<const Ray> rays, std::span<Hit> hits, bool coherent = false) const;
  /// blocked[i] is 1 where ray i meets anything, else 0.
  void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A ray origin moved off the surface along the geometric normal, on the side of n, by a
/// distance that is safe in single precision for the magnitude of p.
vec3 offsetOrigin(const vec3& p, const vec3& n);

}  // namespace soffit::geometry

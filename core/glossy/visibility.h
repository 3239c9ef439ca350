// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/math/vec.h"
#include "core/sh/index.h"
#include "core/sh/sphere_samples.h"

#include <cstdint>
#include <span>
#include <vector>

/// Which directions are open at receivers: a bit each (Fujita & Kanai's shadow pass), and its SH
/// coefficients.
namespace soffit::glossy {

/// Receivers times directions, a bit each: 1 where light from afar arrives.
class VisibilityBits {
 public:
  VisibilityBits(std::size_t receivers, std::size_t directions);

  [[nodiscard]] std::size_t receivers() const { return receivers_; }
  [[nodiscard]] std::size_t directions() const { return directions_; }
  [[nodiscard]] std::size_t bytes() const { return words_.size() * sizeof(std::uint64_t); }

  [[nodiscard]] bool open(std::size_t receiver, std::size_t direction) const {
    return ((words_[receiver * stride_ + direction / 64] >> (direction % 64)) & 1U) != 0;
  }
  void setOpen(std::size_t receiver, std::size_t direction) {
    words_[receiver * stride_ + direction / 64] |= std::uint64_t{1} << (direction % 64);
  }

 private:
  std::size_t receivers_, directions_, stride_;
  std::vector<std::uint64_t> words_;
};

/// Casts a ray from every receiver along every direction above its surface: open where nothing is
/// met within `reach` metres. Positions in the caster's frame, normals unit, equally many; rays
/// start offset along the normal. Receivers in parallel; the same on every number of threads.
VisibilityBits lookAround(const geometry::RayCaster& scene, std::span<const vec3> positions,
                          std::span<const vec3> normals, const sh::SphereSamples& samples,
                          float reach = std::numeric_limits<float>::infinity());

/// Projects a receiver's bits: v_k = sum of w y_k over the open directions. bands in 1 ..
/// sh::kMaxBands. Error: that of the sample set, about 1.5 / sqrt(directions) of v_0 per
/// coefficient at worst for independent directions, less for cube-map texels along straight edges.
sh::Coefficients visibilityCoefficients(const VisibilityBits& bits, std::size_t receiver,
                                        const sh::SphereSamples& samples, int bands);

}  // namespace soffit::glossy

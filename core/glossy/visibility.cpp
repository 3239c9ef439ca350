// SPDX-License-Identifier: MIT
#include "core/glossy/visibility.h"

#include "core/base/parallel.h"
#include "core/sh/basis.h"

#include <array>
#include <cassert>

namespace soffit::glossy {

VisibilityBits::VisibilityBits(std::size_t receivers, std::size_t directions)
    : receivers_(receivers),
      directions_(directions),
      stride_((directions + 63) / 64),
      words_(receivers * stride_, 0) {}

VisibilityBits lookAround(const geometry::RayCaster& scene, std::span<const vec3> positions,
                          std::span<const vec3> normals, const sh::SphereSamples& samples,
                          float reach) {
  assert(positions.size() == normals.size());
  VisibilityBits bits(positions.size(), samples.size());
  parallelFor(positions.size(), 4, [&](std::size_t begin, std::size_t end) {
    std::vector<geometry::Ray> rays;
    std::vector<std::size_t> of;
    std::vector<std::uint8_t> blocked;
    for (std::size_t r = begin; r < end; ++r) {
      rays.clear();
      of.clear();
      const vec3 origin = geometry::offsetOrigin(positions[r], normals[r]);
      for (std::size_t k = 0; k < samples.size(); ++k) {
        const vec3 direction(samples.directions[k]);
        if (glm::dot(direction, normals[r]) <= 0.0F) continue;
        rays.push_back({origin, 0.0F, direction, reach});
        of.push_back(k);
      }
      blocked.resize(rays.size());
      scene.occluded(rays, blocked);
      for (std::size_t i = 0; i < of.size(); ++i) {
        if (blocked[i] == 0) bits.setOpen(r, of[i]);
      }
    }
  });
  return bits;
}

sh::Coefficients visibilityCoefficients(const VisibilityBits& bits, std::size_t receiver,
                                        const sh::SphereSamples& samples, int bands) {
  assert(samples.size() == bits.directions());
  sh::Coefficients v(sh::coefficientCount(bands), 0.0);
  std::array<double, sh::kMaxCoefficients> basis;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!bits.open(receiver, k)) continue;
    sh::evaluate(samples.directions[k], bands, basis);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += samples.weights[k] * basis[i];
  }
  return v;
}

}  // namespace soffit::glossy

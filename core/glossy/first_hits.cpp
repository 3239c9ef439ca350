// SPDX-License-Identifier: MIT
#include "core/glossy/first_hits.h"

#include "core/base/parallel.h"

#include <cassert>

namespace soffit::glossy {

FirstHits::FirstHits(const geometry::RayCaster& scene, std::span<const vec3> positions,
                     std::span<const vec3> normals,
                     std::shared_ptr<const sh::SphereSamples> samples)
    : samples_(std::move(samples)),
      positions_(positions.begin(), positions.end()),
      normals_(normals.begin(), normals.end()),
      hits_(positions.size() * samples_->size()) {
  assert(normals.empty() || normals.size() == positions.size());
  const std::size_t count = samples_->size();
  parallelFor(positions_.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<geometry::Ray> rays(count);
    for (std::size_t i = begin; i < end; ++i) {
      const vec3 origin =
          normals_.empty() ? positions_[i] : geometry::offsetOrigin(positions_[i], normals_[i]);
      for (std::size_t k = 0; k < count; ++k) {
        rays[k] = {origin, 0.0F, vec3(samples_->directions[k])};
        if (!above(i, k)) rays[k].t_max = -1.0F;  // meets nothing
      }
      scene.closest(rays, std::span(hits_).subspan(i * count, count));
      // An empty interval is no promise of every ray caster's packets.
      for (std::size_t k = 0; k < count; ++k) {
        if (!above(i, k)) hits_[i * count + k] = {};
      }
    }
  });
}

std::vector<vec3> lightHits(const FirstHits& first, std::size_t i, const HitRadiance& light,
                            const vec3& background) {
  const std::span<const geometry::Hit> all = first.hits(i);
  std::vector<vec3> radiance(all.size(), vec3(0.0F));
  std::vector<geometry::Ray> rays;
  std::vector<geometry::Hit> hits;
  std::vector<std::size_t> of;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].valid()) {
      rays.push_back({first.position(i), 0.0F, vec3(first.samples().directions[k])});
      hits.push_back(all[k]);
      of.push_back(k);
    } else if (first.above(i, k)) {
      radiance[k] = background;
    }
  }
  std::vector<vec3> found(hits.size(), vec3(0.0F));
  light(rays, hits, found);
  for (std::size_t k = 0; k < of.size(); ++k) radiance[of[k]] = found[k];
  return radiance;
}

std::vector<vec3> gatherSources(std::span<const std::uint32_t> source_of,
                                std::span<const vec3> values) {
  std::vector<vec3> radiance(source_of.size(), vec3(0.0F));
  for (std::size_t k = 0; k < source_of.size(); ++k) {
    if (source_of[k] != kNoSource) radiance[k] = values[source_of[k]];
  }
  return radiance;
}

}  // namespace soffit::glossy

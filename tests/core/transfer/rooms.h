// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/hemisphere.h"
#include "tests/core/transfer/small_bake.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

/// Rooms and their first bake stages, for the tests of transfer.
namespace soffit::transfer::testing {

/// A box whose fronts look inward.
inline geometry::Mesh roomBox(const vec3& lo, const vec3& hi) {
  geometry::Mesh mesh = geometry::makeBox(lo, hi);
  for (uvec3& t : mesh.triangles) std::swap(t.y, t.z);
  return mesh;
}

/// 4 x 3 x 2.5 m with a block that stands free: 1 x 0.5 x 1 m.
inline geometry::Mesh blockRoom() {
  geometry::Mesh mesh;
  append(mesh, roomBox({0, 0, 0}, {4, 3, 2.5F}), 0);
  append(mesh, geometry::makeBox({1, 1, 0.5F}, {2, 1.5F, 1.5F}), 1);
  return mesh;
}
inline constexpr double kBlockRoomArea =
    2 * (4 * 3 + 4 * 2.5 + 3 * 2.5) + 2 * (0.5 + 1.0 + 0.5);  ///< m^2

inline double sum(const std::vector<float>& values) {
  double total = 0.0;
  for (const float v : values) total += static_cast<double>(v);
  return total;
}

/// Texel slots that rays^2 rays of every slot meet, as the bake traces them.
inline std::vector<std::uint32_t> firstHits(const StaticScene& scene, const Texels& texels,
                                            int rays) {
  std::vector<std::uint32_t> out;
  HemisphereScratch scratch;
  HemisphereHits hits;
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    traceHemisphere(scene, texels, texels.receivers.position(s), texels.receivers.normal(s), rays,
                    s, texels.gapReach(s), scratch, hits);
    out.insert(out.end(), hits.slots.begin(), hits.slots.end());
  }
  return out;
}

}  // namespace soffit::transfer::testing

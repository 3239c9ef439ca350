// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/box.h"
#include "core/math/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soffit::light {

/// Points that receive light, in clusters of neighbours that look the same way; the unit of
/// culling is the cluster, the unit of computing a group of 16 points.
///
/// Structure of arrays; each cluster starts at a multiple of 16 and is padded with copies of its
/// last point. Slot: a place in these arrays; the caller's point i lies at slot slot_of[i].
struct Receivers {
  static constexpr std::uint32_t kGroup = 16;

  std::vector<float> x, y, z;     ///< positions, scene-local
  std::vector<float> nx, ny, nz;  ///< unit normals
  std::vector<std::uint32_t> slot_of;   ///< per point
  std::vector<std::uint32_t> point_of;  ///< per slot; padding repeats a point

  struct Bounds {
    Box box;
    vec3 normal{0.0F};       ///< common normal, unit; zero when the normals differ
    float plane_min = 0.0F;  ///< least normal.position, when there is a common normal
  };
  struct Cluster {
    std::uint32_t begin = 0;  ///< first slot
    std::uint32_t end = 0;    ///< one past the last slot, padding included
    std::uint32_t used = 0;   ///< number of points
    Bounds bounds;
  };
  std::vector<Cluster> clusters;
  std::vector<Bounds> groups;  ///< per 16 slots

  [[nodiscard]] std::size_t slotCount() const { return x.size(); }
  [[nodiscard]] std::size_t pointCount() const { return slot_of.size(); }
  [[nodiscard]] vec3 position(std::size_t slot) const { return {x[slot], y[slot], z[slot]}; }
  [[nodiscard]] vec3 normal(std::size_t slot) const { return {nx[slot], ny[slot], nz[slot]}; }
};

/// Groups points by normal class and position.
///
/// positions, normals  one per point, normals unit; scene-local.
/// cluster_size        wished points per cluster, a multiple of 16; clusters hold at most this.
/// regions             per point, or empty: points of different regions never share a cluster.
/// Deterministic; O(n log n).
Receivers makeReceivers(std::span<const vec3> positions, std::span<const vec3> normals, std::uint32_t cluster_size,
                        std::span<const std::uint32_t> regions = {});

/// The same from given clusters: `order` lists points, cluster k is order[offsets[k] .. offsets[k+1]).
Receivers makeReceivers(std::span<const vec3> positions, std::span<const vec3> normals,
                        std::span<const std::uint32_t> order, std::span<const std::uint32_t> offsets);

/// The same grouped for culling alone: a k-d tree over position and normal together, so that every
/// group of 16 is small and looks one way, and every group but the last is full. Points that lie
/// close but look elsewhere may share a cluster. What shadows cost depends on this: a group that
/// reaches over three desks meets the blockers of all three.
Receivers makeCompactReceivers(std::span<const vec3> positions, std::span<const vec3> normals);

/// A partition of points by region and normal class, then by distance and position (k-d split),
/// into sets of at most `cluster_size`. Writes the order and the offsets of the clusters.
void clusterPoints(std::span<const vec3> positions, std::span<const vec3> normals, std::uint32_t cluster_size,
                   std::span<const std::uint32_t> regions, std::vector<std::uint32_t>& order,
                   std::vector<std::uint32_t>& offsets);

}  // namespace soffit::light

// SPDX-License-Identifier: MIT
#include "core/prt/vertex_receivers.h"

#include "core/geometry/weld.h"
#include "core/prt/material_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace soffit::prt {
namespace {

struct Corner {
  std::uint32_t point;  ///< first vertex at the same place
  std::uint32_t material;
  vec3 normal;  ///< on the receiving side
  std::uint32_t triangle;
  std::uint32_t k;
  bool front;

  [[nodiscard]] auto key() const {
    return std::make_tuple(point, material, normal.x, normal.y, normal.z, front);
  }
};

constexpr float kMostInward = 1e-3F;   // m
constexpr float kShareInward = 0.05F;  // of the way to the middle of the triangles about it
constexpr float kBorder = 0.05F;       // of their size: nearer to the middle is not a border

}  // namespace

VertexReceivers::VertexReceivers(std::shared_ptr<const Surfaces> surfaces)
    : surfaces_(std::move(surfaces)) {
  numberCorners();
  accumulate();
  drawInward();
}

void VertexReceivers::numberCorners() {
  const Surfaces& s = *surfaces_;
  const geometry::Mesh& mesh = *s.mesh;
  const std::vector<std::uint32_t> point = geometry::weldPositions(mesh.positions, 0.0F);
  for (auto& list : corner_) list.assign(3 * s.triangleCount(), kNoReceiver);
  std::vector<Corner> corners;
  for (std::uint32_t t = 0; t < s.triangleCount(); ++t) {
    const std::uint32_t material = t < mesh.material_of.size() ? mesh.material_of[t] : 0;
    for (const bool front : {true, false}) {
      if (!s.receives(t, front)) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const vec3& n = s.corner_normals[3 * std::size_t{t} + k];
        corners.push_back(
            {point[mesh.triangles[t][static_cast<int>(k)]], material, front ? n : -n, t, k, front});
      }
    }
  }
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& a, const Corner& b) { return a.key() < b.key(); });
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& c = corners[i];
    if (i == 0 || corners[i - 1].key() != c.key()) {
      receivers_.positions.push_back(mesh.positions[c.point]);
      receivers_.normals.push_back(c.normal);
    }
    corner_[c.front ? 0 : 1][3 * std::size_t{c.triangle} + c.k] =
        static_cast<std::uint32_t>(receivers_.positions.size() - 1);
  }
}

/// Areas, geometric normals and reflectances from the triangles about each vertex.
void VertexReceivers::accumulate() {
  const Surfaces& s = *surfaces_;
  Receivers& r = receivers_;
  r.facing.assign(r.size(), vec3(0.0F));
  r.reflectance.assign(r.size(), vec3(0.0F));
  r.areas.assign(r.size(), 0.0F);
  for (std::uint32_t t = 0; t < s.triangleCount(); ++t) {
    const float third = s.areas[t] / 3.0F;
    for (int k = 0; k < 3; ++k) {
      const MapPlace place{t, k == 1 ? 1.0F : 0.0F, k == 2 ? 1.0F : 0.0F, std::sqrt(third)};
      for (const bool front : {true, false}) {
        const std::uint32_t i = of(t, k, front);
        if (i == kNoReceiver) continue;
        r.areas[i] += third;
        r.facing[i] += (front ? third : -third) * s.normals[t];
        r.reflectance[i] += third * reflectanceAt(s, place);
      }
    }
  }
  for (std::size_t i = 0; i < r.size(); ++i) {
    r.facing[i] =
        glm::dot(r.facing[i], r.facing[i]) > 0.0F ? glm::normalize(r.facing[i]) : r.normals[i];
    r.reflectance[i] /= r.areas[i];
  }
}

void VertexReceivers::drawInward() {
  const Surfaces& s = *surfaces_;
  Receivers& r = receivers_;
  std::vector<vec3> middle(r.size(), vec3(0.0F));  // from the vertex, weighted by area
  for (std::uint32_t t = 0; t < s.triangleCount(); ++t) {
    const vec3 center = (s.corner(t, 0) + s.corner(t, 1) + s.corner(t, 2)) / 3.0F;
    for (int k = 0; k < 3; ++k) {
      for (const bool front : {true, false}) {
        const std::uint32_t i = of(t, k, front);
        if (i != kNoReceiver) middle[i] += s.areas[t] / 3.0F * (center - s.corner(t, k));
      }
    }
  }
  for (std::size_t i = 0; i < r.size(); ++i) {
    vec3 way = middle[i] / r.areas[i];
    way -= glm::dot(way, r.facing[i]) * r.facing[i];
    const float length = glm::length(way);
    if (!(length > kBorder * std::sqrt(r.areas[i]))) continue;
    r.positions[i] += std::min(kShareInward, kMostInward / length) * way;
  }
}

std::size_t VertexReceivers::around(const geometry::Hit& hit, bool front, Around& taps) const {
  const float weights[3] = {1.0F - hit.u - hit.v, hit.u, hit.v};
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t i = of(hit.triangle, k, front);
    if (i == kNoReceiver) return 0;
    taps[static_cast<std::size_t>(k)] = {i, weights[k]};
  }
  return 3;
}

std::vector<std::uint32_t> VertexReceivers::nearestValid(
    std::span<const std::uint8_t> valid) const {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t t = 0; t < surfaces_->triangleCount(); ++t) {
    for (const bool front : {true, false}) {
      for (int k = 0; k < 3 && of(t, 0, front) != kNoReceiver; ++k) {
        const std::uint32_t a = of(t, k, front);
        const std::uint32_t b = of(t, (k + 1) % 3, front);
        pairs.push_back({a, b});
        pairs.push_back({b, a});
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<std::uint32_t> offsets(receivers_.size() + 1, 0);
  std::vector<std::uint32_t> neighbors;
  for (const auto& p : pairs) {
    ++offsets[p[0] + 1];
    neighbors.push_back(p[1]);
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  return spreadFromValid(valid, offsets, neighbors);
}

}  // namespace soffit::prt

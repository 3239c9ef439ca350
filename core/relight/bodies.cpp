// SPDX-License-Identifier: MIT
#include "core/relight/bodies.h"

#include "core/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace soffit::relight {
namespace {

light::MaskBlocker polygon(std::span<const dvec3> corners, bool solid) {
  light::MaskBlocker b;
  b.count = static_cast<int>(std::min<std::size_t>(corners.size(), 4));
  for (int i = 0; i < b.count; ++i)
    b.corners[static_cast<std::size_t>(i)] = vec3(corners[static_cast<std::size_t>(i)]);
  const dvec3 n = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  b.normal = vec3(glm::normalize(n));
  b.d = glm::dot(b.normal, b.corners[0]);
  b.solid = solid;
  return b;
}

void pushTriangle(const dvec3& a, const dvec3& b, const dvec3& c, bool solid,
                  std::vector<light::MaskBlocker>& out) {
  if (glm::length(glm::cross(b - a, c - a)) <= 0.0) return;
  const std::array<dvec3, 3> corners = {a, b, c};
  out.push_back(polygon(corners, solid));
}

bool isConvex(std::span<const dvec3> outline, const dvec3& n) {
  bool left = true;
  bool right = true;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const dvec3& b = outline[(i + 1) % outline.size()];
    const double turn =
        glm::dot(n, glm::cross(b - outline[i], outline[(i + 2) % outline.size()] - b));
    left = left && turn >= 0.0;
    right = right && turn <= 0.0;
  }
  return left || right;
}

/// A regular outline with the disk's area as a fan of quads.
void pushDisk(const dvec3& center, const dvec3& axis, double radius,
              std::vector<light::MaskBlocker>& out) {
  constexpr int kCorners = 24;
  const double step = 2.0 * kPi / kCorners;
  const double r = radius * std::sqrt(step / std::sin(step));
  dvec3 t;
  dvec3 b;
  orthonormalBasis(axis, t, b);
  const auto rim = [&](int i) {
    return center + r * (std::cos(i * step) * t + std::sin(i * step) * b);
  };
  for (int i = 0; i < kCorners; i += 2) {
    const std::array<dvec3, 4> quad = {center, rim(i), rim(i + 1), rim(i + 2)};
    out.push_back(polygon(quad, false));
  }
}

void pushSphere(const light::Emitter& e, std::vector<light::MaskBlocker>& out) {
  constexpr int kRings = 8;
  constexpr int kSectors = 16;
  // The silhouette of a polyhedron lies inside the ball's: grow it to the same area.
  const double r = e.radius * std::sqrt((2.0 * kPi / kSectors) / std::sin(2.0 * kPi / kSectors));
  const auto at = [&](int ring, int sector) {
    const double theta = kPi * ring / kRings;
    const double phi = 2.0 * kPi * sector / kSectors;
    return e.position + r * dvec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                  std::cos(theta));
  };
  for (int i = 0; i < kRings; ++i) {
    for (int j = 0; j < kSectors; ++j) {
      pushTriangle(at(i, j), at(i + 1, j), at(i + 1, j + 1), true, out);
      pushTriangle(at(i, j), at(i + 1, j + 1), at(i, j + 1), true, out);
    }
  }
}

void pushTube(const light::Emitter& e, std::vector<light::MaskBlocker>& out) {
  constexpr int kSectors = 12;
  dvec3 t;
  dvec3 b;
  orthonormalBasis(e.axis, t, b);
  const dvec3 end = e.half_length * e.axis;
  const double r = e.radius / std::cos(kPi / kSectors / 2.0);
  const auto rim = [&](int i) {
    return e.position +
           r * (std::cos(2.0 * kPi * i / kSectors) * t + std::sin(2.0 * kPi * i / kSectors) * b);
  };
  for (int i = 0; i < kSectors; ++i) {
    const std::array<dvec3, 4> side = {rim(i) - end, rim(i + 1) - end, rim(i + 1) + end,
                                       rim(i) + end};
    out.push_back(polygon(side, true));
    pushTriangle(e.position + end, rim(i) + end, rim(i + 1) + end, true, out);
    pushTriangle(e.position - end, rim(i + 1) - end, rim(i) - end, true, out);
  }
}

/// Distance-free test: is the point of the emitter's plane inside its outline?
bool covers(const light::Emitter& e, const dvec3& p) {
  if (e.disk) return glm::length(p - e.position) <= e.radius;
  bool inside = false;
  dvec3 t;
  dvec3 b;
  orthonormalBasis(e.normal, t, b);
  const double x = glm::dot(p, t);
  const double y = glm::dot(p, b);
  for (std::size_t i = 0, j = e.outline.size() - 1; i < e.outline.size(); j = i++) {
    const dvec2 a(glm::dot(e.outline[i], t), glm::dot(e.outline[i], b));
    const dvec2 c(glm::dot(e.outline[j], t), glm::dot(e.outline[j], b));
    if ((a.y > y) != (c.y > y) && x < (c.x - a.x) * (y - a.y) / (c.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

}  // namespace

std::vector<light::MaskBlocker> bodyBlockers(const light::Emitter& e) {
  std::vector<light::MaskBlocker> out;
  if (!e.casts_shadow) return out;
  switch (e.kind) {
    case light::EmitterKind::point:
      break;
    case light::EmitterKind::sphere:
      pushSphere(e, out);
      break;
    case light::EmitterKind::tube:
      pushTube(e, out);
      break;
    case light::EmitterKind::planar:
      if (e.disk) {
        pushDisk(e.position, e.normal, e.radius, out);
      } else if (e.outline.size() == 4 && isConvex(e.outline, e.normal)) {
        out.push_back(polygon(e.outline, false));
      } else {
        for (const uvec3& t : e.outline_triangles)
          pushTriangle(e.outline[t.x], e.outline[t.y], e.outline[t.z], false, out);
      }
      break;
    case light::EmitterKind::mesh:
      for (std::size_t i = 0; i + 2 < e.corners.size(); i += 3) {
        pushTriangle(e.corners[i], e.corners[i + 1], e.corners[i + 2], false, out);
      }
      break;
  }
  return out;
}

void coverTexels(const light::Emitter& e, const transfer::Texels& texels, std::span<float> open) {
  if (!e.casts_shadow || e.kind != light::EmitterKind::planar) return;
  const dvec3 center = e.disk ? e.position : 0.5 * dvec3(e.bounds.lo + e.bounds.hi);
  const double size = static_cast<double>(e.bounds.diagonal());
  const double gap = 0.1 * size;
  constexpr int kTaps = 6;
  for (const light::Receivers::Cluster& c : texels.receivers.clusters) {
    const vec3 middle(center);
    if (c.bounds.box.distanceSquared(middle) > static_cast<float>(0.4 * size * size)) continue;
    for (std::uint32_t s = c.begin; s < c.end; ++s) {
      const dvec3 n(texels.receivers.normal(s));
      const dvec3 p(texels.receivers.position(s));
      // Parallel, and the body a little in front of the texel.
      const double height = glm::dot(n, center - p);
      if (std::abs(glm::dot(n, e.normal)) < 0.99 || height <= 0.0 || height > gap) continue;
      const transfer::Chart& chart =
          texels.charts.charts[texels.charts.chart_of[texels.triangle[s]]];
      const double side = std::sqrt(static_cast<double>(texels.area[s]));
      int hidden = 0;
      for (int j = 0; j < kTaps; ++j) {
        for (int i = 0; i < kTaps; ++i) {
          const double a = ((i + 0.5) / kTaps - 0.5) * side;
          const double b = ((j + 0.5) / kTaps - 0.5) * side;
          dvec3 q = p + a * dvec3(chart.t) + b * dvec3(chart.b);
          q += glm::dot(center - q, e.normal) * e.normal;
          hidden += covers(e, q) ? 1 : 0;
        }
      }
      open[s] *= 1.0F - static_cast<float>(hidden) / static_cast<float>(kTaps * kTaps);
    }
  }
}

Box boxOf(std::span<const light::MaskBlocker> blockers) {
  Box box;
  for (const light::MaskBlocker& face : blockers) {
    for (int i = 0; i < face.count; ++i) box.add(face.corners[static_cast<std::size_t>(i)]);
  }
  return box;
}

std::vector<float> openShare(std::span<const light::Emitter> emitters,
                             const transfer::Texels& texels) {
  std::vector<float> open;
  for (const light::Emitter& e : emitters) {
    if (!e.casts_shadow) continue;
    if (open.empty()) open.assign(texels.slotCount(), 1.0F);
    coverTexels(e, texels, open);
  }
  return open;
}

}  // namespace soffit::relight

// SPDX-License-Identifier: MIT
#include "core/geometry/polygon.h"

#include <cmath>
#include <cstdint>

namespace soffit::geometry {
namespace {

constexpr std::size_t kMaxCorners = 30000;

dvec3 newellNormal(std::span<const dvec3> corners) {
  dvec3 sum(0.0);
  const dvec3 base = corners[0];  // differences: far from the origin products would lose digits
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += glm::cross(corners[i] - base, corners[(i + 1) % corners.size()] - base);
  }
  return sum;
}

// The polygon seen along the axis its normal is closest to, turned so that it runs counter-
// clockwise.
std::vector<dvec2> flattened(std::span<const dvec3> corners) {
  const dvec3 n = newellNormal(corners);
  const dvec3 a = glm::abs(n);
  const int axis = a.x > a.y && a.x > a.z ? 0 : a.y > a.z ? 1 : 2;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  std::vector<dvec2> out;
  out.reserve(corners.size());
  for (const dvec3& c : corners) {
    out.push_back(n[axis] < 0.0 ? dvec2(c[v], c[u]) : dvec2(c[u], c[v]));
  }
  return out;
}

// Twice the area of abc, positive counter-clockwise.
double cross(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class EarClipper {
 public:
  explicit EarClipper(std::vector<dvec2> points)
      : points_(std::move(points)), previous_(points_.size()), next_(points_.size()) {
    const auto n = static_cast<std::uint32_t>(points_.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      previous_[i] = (i + n - 1) % n;
      next_[i] = (i + 1) % n;
    }
  }

  std::vector<uvec3> run() {
    std::vector<uvec3> out;
    std::uint32_t at = 0;
    for (std::size_t left = points_.size(); left > 3; --left) {
      at = ear(at, left);
      out.emplace_back(previous_[at], at, next_[at]);
      next_[previous_[at]] = next_[at];
      previous_[next_[at]] = previous_[at];
      at = next_[at];
    }
    out.emplace_back(previous_[at], at, next_[at]);
    return out;
  }

 private:
  [[nodiscard]] double turn(std::uint32_t i) const {
    return cross(points_[previous_[i]], points_[i], points_[next_[i]]);
  }

  // The first corner from `at` on that can be cut off; where rounding or a crossing leaves none,
  // the one that turns least against the winding.
  std::uint32_t ear(std::uint32_t at, std::size_t left) {
    const bool hopeless = misses_ >= kMaxMisses;
    std::uint32_t fallback = at;
    for (std::size_t k = 0; k < left; ++k, at = next_[at]) {
      if (turn(at) > 0.0 && (hopeless || isEmpty(at, left))) return at;
      if (turn(at) > turn(fallback)) fallback = at;
    }
    ++misses_;
    return fallback;
  }

  // No other corner lies in the triangle at i. Corners on the same spot as one of the triangle's
  // (slits of holes) do not count.
  [[nodiscard]] bool isEmpty(std::uint32_t i, std::size_t left) const {
    const dvec2 a = points_[previous_[i]];
    const dvec2 b = points_[i];
    const dvec2 c = points_[next_[i]];
    std::uint32_t other = next_[next_[i]];
    for (std::size_t k = 3; k < left; ++k, other = next_[other]) {
      const dvec2 p = points_[other];
      if (p == a || p == b || p == c || turn(other) > 0.0) continue;
      if (cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0) return false;
    }
    return true;
  }

  // After so many dead ends the polygon is not simple, and care would be wasted (O(n^3)).
  static constexpr int kMaxMisses = 8;

  std::vector<dvec2> points_;
  int misses_ = 0;
  std::vector<std::uint32_t> previous_;
  std::vector<std::uint32_t> next_;
};

std::vector<uvec3> cutQuad(std::span<const dvec3> corners) {
  const std::vector<dvec2> p = flattened(corners);
  const auto distance = [&](std::size_t a, std::size_t b) {
    const dvec3 d = corners[b] - corners[a];
    return glm::dot(d, d);
  };
  const bool along02 = cross(p[0], p[1], p[2]) > 0.0 && cross(p[0], p[2], p[3]) > 0.0;
  const bool along13 = cross(p[1], p[2], p[3]) > 0.0 && cross(p[1], p[3], p[0]) > 0.0;
  if (along13 && (!along02 || distance(1, 3) < distance(0, 2))) return {{0, 1, 3}, {1, 2, 3}};
  return {{0, 1, 2}, {0, 2, 3}};
}

}  // namespace

std::vector<uvec3> triangulatePolygon(std::span<const dvec3> corners) {
  if (corners.size() < 3) return {};
  if (corners.size() == 3) return {{0, 1, 2}};
  if (corners.size() == 4) return cutQuad(corners);
  if (corners.size() <= kMaxCorners) return EarClipper(flattened(corners)).run();
  std::vector<uvec3> fan;
  for (std::uint32_t i = 2; i < corners.size(); ++i) fan.emplace_back(0U, i - 1, i);
  return fan;
}

}  // namespace soffit::geometry

// SPDX-License-Identifier: MIT
#include "core/prt/flat_cover.h"

#include <algorithm>
#include <cmath>

namespace soffit::prt {
namespace {

/// Distance of p from the line a b, positive to its left; 0 without a line.
double leftOf(const vec2& a, const vec2& b, const dvec2& p) {
  const dvec2 e = dvec2(b) - dvec2(a);
  const double length = glm::length(e);
  return length > 0.0 ? (e.x * (p.y - a.y) - e.y * (p.x - a.x)) / length : 0.0;
}

}  // namespace

FlatCover::FlatCover(const vec2& size, float step) : step_(step) {
  constexpr double kMost = 4e6;
  const double points = double{size.x} / step * (double{size.y} / step);
  if (points > kMost) step_ *= static_cast<float>(std::sqrt(points / kMost));
  nx_ = static_cast<int>(size.x / step_) + 1;
  ny_ = static_cast<int>(size.y / step_) + 1;
  taken_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), 0);
}

bool FlatCover::claim(const std::array<vec2, 3>& c) {
  const vec2 lo = glm::min(c[0], glm::min(c[1], c[2])) / step_;
  const vec2 hi = glm::max(c[0], glm::max(c[1], c[2])) / step_;
  const int x0 = std::clamp(static_cast<int>(lo.x), 0, nx_ - 1);
  const int x1 = std::clamp(static_cast<int>(hi.x), 0, nx_ - 1);
  const int y0 = std::clamp(static_cast<int>(lo.y), 0, ny_ - 1);
  const int y1 = std::clamp(static_cast<int>(hi.y), 0, ny_ - 1);
  // Neighbours share an edge: points within rounding of one are nobody's.
  const double slack = 1e-6 * double{step_} * (nx_ + ny_);
  std::vector<std::size_t> points;
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const dvec2 p((x + 0.5) * step_, (y + 0.5) * step_);
      const double a = leftOf(c[0], c[1], p);
      const double b = leftOf(c[1], c[2], p);
      const double d = leftOf(c[2], c[0], p);
      const bool inside =
          (a > slack && b > slack && d > slack) || (a < -slack && b < -slack && d < -slack);
      if (!inside) continue;
      const auto at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x);
      if (taken_[at] != 0) return false;
      points.push_back(at);
    }
  }
  for (const std::size_t at : points) taken_[at] = 1;
  return true;
}

}  // namespace soffit::prt

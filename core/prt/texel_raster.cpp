// SPDX-License-Identifier: MIT
#include "core/prt/texel_raster.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::prt {
namespace {

constexpr float kSliver = 0.02F;

/// A convex polygon of at most 7 corners: a triangle cut by a square.
struct Polygon {
  std::array<dvec2, 8> p;
  std::size_t n = 0;

  /// Keeps the side where sign * (coordinate - at) >= 0.
  void cut(int axis, double at, double sign) {
    Polygon out;
    for (std::size_t i = 0; i < n; ++i) {
      const dvec2& a = p[i];
      const dvec2& b = p[(i + 1) % n];
      const double da = sign * (a[axis] - at);
      const double db = sign * (b[axis] - at);
      if (da >= 0.0) out.p[out.n++] = a;
      if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) {
        dvec2 q = a + da / (da - db) * (b - a);
        q[axis] = at;
        out.p[out.n++] = q;
      }
    }
    *this = out;
  }
  /// Signed area and center of gravity.
  double measure(dvec2& center) const {
    double area = 0.0;
    center = dvec2(0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const dvec2 a = p[i] - p[0];
      const dvec2 b = p[i + 1] - p[0];
      const double twice = a.x * b.y - a.y * b.x;
      area += 0.5 * twice;
      center += 0.5 * twice * (p[0] + p[i] + p[i + 1]) / 3.0;
    }
    if (area != 0.0) center /= area;
    return area;
  }
};

/// One triangle in the texture's plane.
struct FlatTriangle {
  std::array<dvec2, 3> c;
  double twice = 0.0;  ///< signed double area

  explicit FlatTriangle(const std::array<vec2, 3>& corners)
      : c{dvec2(corners[0]), dvec2(corners[1]), dvec2(corners[2])} {
    twice = cross(c[1] - c[0], c[2] - c[0]);
  }
  static double cross(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }
  /// u, v of a point.
  [[nodiscard]] dvec2 barycentric(const dvec2& p) const {
    return {cross(p - c[0], c[2] - c[0]) / twice, cross(c[1] - c[0], p - c[0]) / twice};
  }
};

/// What one triangle gives to one texel.
struct Piece {
  RasterTexel texel;
  bool center = false;  ///< the texel's centre lies on the triangle
};

class Raster {
 public:
  Raster(const Surfaces& s, const TextureLayout& layout, const Job& job)
      : surfaces_(s), layout_(layout), job_(job) {}

  std::vector<RasterTexel> make() {
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t i = 0; i < layout_.triangles.size(); ++i) {
        if (layout_.chart_of[side][i] != TextureLayout::kNoChart) addTriangle(side, i);
      }
    }
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [](const Piece& a, const Piece& b) { return a.texel.texel < b.texel.texel; });
    return withoutSlivers(joined());
  }

 private:
  void addTriangle(std::size_t side, std::size_t i) {
    const FlatTriangle t(layout_.corners[side][i]);
    if (t.twice == 0.0) return;
    const std::uint32_t triangle = layout_.triangles[i];
    Piece piece;
    piece.texel.chart = layout_.chart_of[side][i];
    piece.texel.triangle = triangle;
    piece.texel.front = side == 0;
    const double metres = double{surfaces_.areas[triangle]} / (0.5 * std::abs(t.twice));
    const dvec2 lo = glm::min(t.c[0], glm::min(t.c[1], t.c[2]));
    const dvec2 hi = glm::max(t.c[0], glm::max(t.c[1], t.c[2]));
    const int x1 = std::min(static_cast<int>(hi.x), layout_.width - 1);
    const int y1 = std::min(static_cast<int>(hi.y), layout_.height - 1);
    for (int y = static_cast<int>(lo.y); y <= y1 && !job_.cancelled(); ++y) {
      for (int x = static_cast<int>(lo.x); x <= x1; ++x) addPiece(t, x, y, metres, piece);
    }
  }

  void addPiece(const FlatTriangle& t, int x, int y, double metres, Piece& piece) {
    Polygon polygon{{t.c[0], t.c[1], t.c[2]}, 3};
    polygon.cut(0, x, 1.0);
    polygon.cut(0, x + 1, -1.0);
    polygon.cut(1, y, 1.0);
    polygon.cut(1, y + 1, -1.0);
    dvec2 place;
    const double area = std::abs(polygon.measure(place));
    if (!(area > 0.0)) return;
    const dvec2 middle(x + 0.5, y + 0.5);
    const dvec2 at_middle = t.barycentric(middle);
    piece.center = at_middle.x >= 0.0 && at_middle.y >= 0.0 && at_middle.x + at_middle.y <= 1.0;
    const dvec2 at = piece.center ? at_middle : t.barycentric(place);
    piece.texel.texel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(layout_.width) +
                        static_cast<std::uint32_t>(x);
    piece.texel.u = static_cast<float>(std::clamp(at.x, 0.0, 1.0));
    piece.texel.v = static_cast<float>(std::clamp(at.y, 0.0, 1.0 - double{piece.texel.u}));
    piece.texel.area = static_cast<float>(area * metres);
    piece.texel.coverage = static_cast<float>(area);
    pieces_.push_back(piece);
  }

  /// One per texel: its point from the piece with the centre, else from the largest.
  std::vector<RasterTexel> joined() {
    std::vector<RasterTexel> out;
    for (std::size_t i = 0; i < pieces_.size();) {
      std::size_t best = i;
      float area = 0.0F;
      float coverage = 0.0F;
      std::size_t k = i;
      for (; k < pieces_.size() && pieces_[k].texel.texel == pieces_[i].texel.texel; ++k) {
        area += pieces_[k].texel.area;
        coverage += pieces_[k].texel.coverage;
        const bool better = pieces_[k].center != pieces_[best].center
                                ? pieces_[k].center
                                : pieces_[k].texel.coverage > pieces_[best].texel.coverage;
        if (better) best = k;
      }
      out.push_back(pieces_[best].texel);
      out.back().area = area;
      out.back().coverage = std::min(coverage, 1.0F);
      i = k;
    }
    pieces_ = {};
    return out;
  }

  std::vector<RasterTexel> withoutSlivers(std::vector<RasterTexel> texels) const {
    const auto find = [&](int x, int y) -> RasterTexel* {
      if (x < 0 || y < 0 || x >= layout_.width || y >= layout_.height) return nullptr;
      const auto at = static_cast<std::uint32_t>(y * layout_.width + x);
      const auto it = std::lower_bound(
          texels.begin(), texels.end(), at,
          [](const RasterTexel& t, std::uint32_t wanted) { return t.texel < wanted; });
      return it != texels.end() && it->texel == at ? &*it : nullptr;
    };
    std::vector<std::uint8_t> dropped(texels.size(), 0);
    for (std::size_t i = 0; i < texels.size(); ++i) {
      if (texels[i].coverage >= kSliver) continue;
      const int x = static_cast<int>(texels[i].texel) % layout_.width;
      const int y = static_cast<int>(texels[i].texel) / layout_.width;
      RasterTexel* fullest = nullptr;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          RasterTexel* other = find(x + dx, y + dy);
          if (other == nullptr || other->chart != texels[i].chart) continue;
          if (fullest == nullptr || other->coverage > fullest->coverage) fullest = other;
        }
      }
      if (fullest == &texels[i] || fullest->coverage < kSliver) continue;
      fullest->area += texels[i].area;
      dropped[i] = 1;
    }
    std::vector<RasterTexel> kept;
    for (std::size_t i = 0; i < texels.size(); ++i) {
      if (dropped[i] == 0) kept.push_back(texels[i]);
    }
    return kept;
  }

  const Surfaces& surfaces_;
  const TextureLayout& layout_;
  const Job& job_;
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<RasterTexel> rasterize(const Surfaces& surfaces, const TextureLayout& layout,
                                   const Job& job) {
  return Raster(surfaces, layout, job).make();
}

}  // namespace soffit::prt

// SPDX-License-Identifier: MIT
#include "core/prt/texture_layout.h"

#include "core/prt/chart_growth.h"
#include "core/prt/flat_cover.h"
#include "core/prt/skyline.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace soffit::prt {
namespace {

constexpr std::uint8_t kSideBit[2] = {transfer::kFront, transfer::kBack};

int roundedUp(int n, int step) {
  return (n + step - 1) / step * step;
}

double crossOf(const vec2& a, const vec2& b, const vec2& c) {
  return (double{b.x} - a.x) * (double{c.y} - a.y) - (double{b.y} - a.y) * (double{c.x} - a.x);
}

double areaOf(const Surfaces& s, std::span<const std::uint32_t> triangles) {
  double area = 0.0;
  for (const std::uint32_t t : triangles) area += double{s.areas[t]};
  return area;
}

/// One chart on one side, in whole texels.
struct Sheet {
  std::size_t chart = 0;
  int side = 0;
  glm::ivec2 content{1};
};

class Unwrap {
 public:
  Unwrap(const Surfaces& s, const std::vector<std::uint32_t>& triangles,
         const TextureOptions& options)
      : surfaces_(s),
        triangles_(triangles),
        options_(options),
        step_(1 << (std::max(options.levels, 1) - 1)),
        gutter_(roundedUp(std::max(options.dilation, step_), step_)),
        charts_(growCharts(s, triangles, {options.cone_deg, options.texel})) {}

  /// Packed at a texel size; height above most_side means that it does not fit.
  TextureLayout at(double texel) {
    sheets_.clear();
    for (std::size_t c = 0; c < charts_.size(); ++c) {
      const std::uint8_t sides = surfaces_.sides[charts_[c].triangles.front()];
      const auto cells = [texel](float length) {
        return std::max(1, static_cast<int>(std::lround(double{length} / texel)));
      };
      const glm::ivec2 content(cells(charts_[c].size.x), cells(charts_[c].size.y));
      for (int side = 0; side < 2; ++side) {
        if ((sides & kSideBit[side]) != 0) sheets_.push_back({c, side, content});
      }
    }
    TextureLayout layout;
    layout.texel = texel;
    layout.triangles = triangles_;
    pack(layout);
    return layout;
  }

 private:
  void pack(TextureLayout& layout) {
    // In cells of the coarsest level, so that no two charts share one of its texels.
    std::vector<glm::ivec2> sizes;
    double total = 0.0;
    int widest = 1;
    for (const Sheet& sheet : sheets_) {
      const glm::ivec2 size((roundedUp(sheet.content.x, step_) + 2 * gutter_) / step_,
                            (roundedUp(sheet.content.y, step_) + 2 * gutter_) / step_);
      sizes.push_back(size);
      total += double(size.x) * double(size.y);
      widest = std::max(widest, size.x);
    }
    // A square if packing were perfect up to 8 %; then the narrowest that is not too tall.
    int width = std::max(widest, static_cast<int>(std::ceil(std::sqrt(1.08 * total))));
    Packing packing = packRectangles(sizes, width);
    for (int more = std::max(1, width / 32); packing.height > width; width += more) {
      packing = packRectangles(sizes, width + more);
    }
    layout.width = width * step_;
    layout.height = packing.height * step_;
    placeCorners(packing, layout);
  }

  void placeCorners(const Packing& packing, TextureLayout& layout) {
    std::vector<std::uint32_t> local(surfaces_.triangleCount(), 0);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) local[triangles_[i]] = i;
    for (int side = 0; side < 2; ++side) {
      layout.chart_of[static_cast<std::size_t>(side)].assign(triangles_.size(),
                                                             TextureLayout::kNoChart);
      layout.corners[static_cast<std::size_t>(side)].resize(triangles_.size());
    }
    for (std::uint32_t k = 0; k < sheets_.size(); ++k) {
      const Sheet& sheet = sheets_[k];
      const FlatChart& chart = charts_[sheet.chart];
      const vec2 origin(packing.places[k].x * step_ + gutter_,
                        packing.places[k].y * step_ + gutter_);
      const vec2 scale = vec2(sheet.content) / glm::max(chart.size, vec2(1e-20F));
      const auto side = static_cast<std::size_t>(sheet.side);
      for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
        const std::uint32_t at = local[chart.triangles[i]];
        layout.chart_of[side][at] = k;
        for (std::size_t c = 0; c < 3; ++c) {
          layout.corners[side][at][c] =
              origin + glm::min(chart.corners[i][c] * scale, vec2(sheet.content));
        }
      }
    }
    layout.chart_count = static_cast<std::uint32_t>(sheets_.size());
  }

  const Surfaces& surfaces_;
  const std::vector<std::uint32_t>& triangles_;
  TextureOptions options_;
  int step_;
  int gutter_;
  std::vector<FlatChart> charts_;
  std::vector<Sheet> sheets_;
};

/// The texture coordinates of a triangle.
std::array<vec2, 3> uvsOf(const geometry::Mesh& mesh, std::uint32_t triangle) {
  const uvec3& t = mesh.triangles[triangle];
  return {mesh.uvs[t.x], mesh.uvs[t.y], mesh.uvs[t.z]};
}

/// Texels per unit of uv at which the mean texel has the wished size; 0 where the coordinates do
/// not serve.
int sideOfGivenUvs(const Surfaces& s, const std::vector<std::uint32_t>& triangles,
                   const TextureOptions& options) {
  const geometry::Mesh& mesh = *s.mesh;
  if (!options.given_uvs || mesh.uvs.empty() || triangles.empty()) return 0;
  double flat = 0.0;
  for (const std::uint32_t t : triangles) {
    const auto c = uvsOf(mesh, t);
    for (const vec2& p : c) {
      if (!(p.x >= 0.0F && p.y >= 0.0F && p.x <= 1.0F && p.y <= 1.0F)) return 0;
    }
    const double area = 0.5 * std::abs(crossOf(c[0], c[1], c[2]));
    if (!(area > 0.0)) return 0;
    flat += area;
  }
  const int step = 1 << (std::max(options.levels, 1) - 1);
  const double side = options.side > 0 ? options.side / step * step
                                       : std::sqrt(areaOf(s, triangles) / flat) / options.texel;
  const int texels = std::min(roundedUp(std::max(1, static_cast<int>(std::ceil(side))), step),
                              options.most_side / step * step);
  FlatCover cover(vec2(1.0F), 0.25F / static_cast<float>(texels));
  for (const std::uint32_t t : triangles) {
    if (!cover.claim(uvsOf(mesh, t))) return 0;
  }
  return texels;
}

/// Islands of triangles that share vertices.
std::vector<std::uint32_t> islandsOf(const geometry::Mesh& mesh,
                                     const std::vector<std::uint32_t>& triangles,
                                     std::uint32_t& count) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const std::uint32_t t : triangles) {
    const uvec3& c = mesh.triangles[t];
    parent[root(c.y)] = root(c.x);
    parent[root(c.z)] = root(c.x);
  }
  std::vector<std::uint32_t> number(mesh.positions.size(), TextureLayout::kNoChart);
  std::vector<std::uint32_t> islands;
  for (const std::uint32_t t : triangles) {
    std::uint32_t& n = number[root(mesh.triangles[t].x)];
    if (n == TextureLayout::kNoChart) n = count++;
    islands.push_back(n);
  }
  return islands;
}

/// Fronts as given, backs (where there are any) in a second square to the right.
TextureLayout givenLayout(const Surfaces& s, const std::vector<std::uint32_t>& triangles,
                          int side) {
  TextureLayout layout;
  layout.given_uvs = true;
  layout.triangles = triangles;
  layout.width = layout.height = side;
  double flat = 0.0;
  for (const std::uint32_t t : triangles) {
    const auto c = uvsOf(*s.mesh, t);
    flat += 0.5 * std::abs(crossOf(c[0], c[1], c[2]));
  }
  layout.texel = std::sqrt(areaOf(s, triangles) / flat) / side;
  std::uint32_t islands = 0;
  const std::vector<std::uint32_t> island = islandsOf(*s.mesh, triangles, islands);
  const auto any = [&](std::uint8_t bit) {
    return std::any_of(triangles.begin(), triangles.end(),
                       [&](std::uint32_t t) { return (s.sides[t] & bit) != 0; });
  };
  const bool both = any(transfer::kFront) && any(transfer::kBack);
  if (both) layout.width = 2 * side;
  for (std::size_t k = 0; k < 2; ++k) {
    layout.corners[k].resize(triangles.size());
    const float shift = both && k == 1 ? 1.0F : 0.0F;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const bool receives = (s.sides[triangles[i]] & kSideBit[k]) != 0;
      layout.chart_of[k].push_back(receives ? island[i] + static_cast<std::uint32_t>(k) * islands
                                            : TextureLayout::kNoChart);
      const auto uvs = uvsOf(*s.mesh, triangles[i]);
      for (std::size_t c = 0; c < 3; ++c) {
        layout.corners[k][i][c] = static_cast<float>(side) * (uvs[c] + vec2(shift, 0.0F));
      }
    }
  }
  layout.chart_count = 2 * islands;
  return layout;
}

std::vector<std::uint32_t> receiving(const Surfaces& s, std::span<const std::uint32_t> triangles) {
  std::vector<std::uint32_t> out;
  std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(out),
               [&](std::uint32_t t) { return s.sides[t] != transfer::kNoSide; });
  return out;
}

int sideOf(const TextureLayout& layout) {
  return std::max(layout.width, layout.height);
}

/// The layout with the smallest texels from `least` on that fits the side, within 2 %. Gutters
/// keep a texture of very many charts from shrinking: that stays as small as it gets.
TextureLayout fitted(Unwrap& unwrap, double least, int side) {
  double small = least;
  double large = small;
  TextureLayout layout = unwrap.at(large);
  if (sideOf(layout) <= side) return layout;
  for (int i = 0; i < 40 && sideOf(layout) > side; ++i) {
    small = large;
    layout = unwrap.at(large *= 1.5);
  }
  while (large > 1.02 * small) {
    const double middle = std::sqrt(small * large);
    TextureLayout other = unwrap.at(middle);
    if (sideOf(other) <= side) {
      large = middle;
      layout = std::move(other);
    } else {
      small = middle;
    }
  }
  return layout;
}

}  // namespace

TextureLayout layOut(const Surfaces& surfaces, std::span<const std::uint32_t> triangles,
                     const TextureOptions& options) {
  const std::vector<std::uint32_t> kept = receiving(surfaces, triangles);
  if (kept.empty()) return {};
  if (const int side = sideOfGivenUvs(surfaces, kept, options); side > 0) {
    return givenLayout(surfaces, kept, side);
  }
  TextureOptions wished = options;
  if (options.side > 0) wished.texel = std::sqrt(areaOf(surfaces, kept)) / options.side;
  Unwrap unwrap(surfaces, kept, wished);
  return fitted(unwrap, wished.texel, options.side > 0 ? options.side : options.most_side);
}

}  // namespace soffit::prt

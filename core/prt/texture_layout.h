// SPDX-License-Identifier: MIT
#pragma once

#include "core/prt/surfaces.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

/// Where surfaces lie in their transfer texture: given texture coordinates where these serve, an
/// automatic unwrap and packing otherwise.
namespace soffit::prt {

struct TextureOptions {
  double texel = 0.05;    ///< wished side of a texel on the surface, m
  int side = 0;           ///< > 0: instead of `texel`, the side of each set's square, in texels
  int levels = 3;         ///< mip levels with the finest; charts are kept apart on all of them
  int dilation = 3;       ///< texels around charts that repeat their edge (PRTT)
  int most_side = 4096;   ///< texels; a set that would be larger gets larger texels
  double cone_deg = 40;   ///< how far a chart may bend (chart_growth.h)
  bool given_uvs = true;  ///< use the mesh's texture coordinates where they are one to one
};

/// A set's texture plane: x to the right, y upward, in texels; texel (i, j) covers [i, i+1] x
/// [j, j+1].
struct TextureLayout {
  int width = 0, height = 0;  ///< multiples of 2^(levels - 1); 0 where nothing receives light
  double texel = 0.05;        ///< m, that was reached
  bool given_uvs = false;
  std::vector<std::uint32_t> triangles;  ///< those that receive light on some side

  /// Per side (0 front, 1 back) and element of `triangles`: chart, kNoChart where that side
  /// receives nothing, and the corners' places.
  static constexpr std::uint32_t kNoChart = std::numeric_limits<std::uint32_t>::max();
  std::array<std::vector<std::uint32_t>, 2> chart_of;
  std::array<std::vector<std::array<vec2, 3>>, 2> corners;
  std::uint32_t chart_count = 0;
};

/// Lays out one set. triangles: any of the surfaces'; those that receive nothing are left out.
///
/// Given coordinates serve when they lie in [0, 1], do not fold (checked at a quarter of a texel)
/// and give area to every triangle that has some. Otherwise charts are grown, stretched to whole
/// texels (by less than half a texel), and packed with gaps of at least one texel of the coarsest
/// level and `dilation` of the finest on each side of every chart. With `side` the texel size is
/// the one at which the set just fits the square, within 2 %.
TextureLayout layOut(const Surfaces& surfaces, std::span<const std::uint32_t> triangles,
                     const TextureOptions& options);

}  // namespace soffit::prt

// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/prt/receivers.h"
#include "core/prt/transfer_rows.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soffit::prt {

/// What a texel of a transfer texture holds.
enum class TexelKind : std::uint8_t {
  empty,    ///< nothing: never looked at
  dilated,  ///< repeats the nearest texel with a surface, against seams
  covered,  ///< a surface of its own
};

/// One mip level of a set's texture. Its light is a list of items, one per covered texel; dilation
/// is part of the map from texels to items and costs neither memory nor evaluation.
struct TextureLevel {
  int width = 0, height = 0;
  std::vector<std::uint32_t> item;   ///< per texel, row y * width; kNoReceiver where empty
  std::vector<TexelKind> kind;       ///< per texel
  std::vector<std::uint32_t> texel;  ///< per item
  std::vector<float> area;           ///< per item, m^2
  /// Items of the finer level that item k averages, with their shares of its area, from
  /// children[first[k]] on; none at the finest.
  std::vector<std::uint32_t> first;
  std::vector<Tap> children;

  [[nodiscard]] std::size_t items() const { return texel.size(); }
};

/// The finest level. texels: of the items, ascending.
TextureLevel finestLevel(int width, int height, std::vector<std::uint32_t> texels,
                         std::vector<float> areas, int dilation);

/// Half the size: 2 x 2 texels become one, which is covered where any of them was.
TextureLevel coarserLevel(const TextureLevel& finer, int dilation);

/// Rows of a coarser level: means of its children, weighted by their areas; only covered texels
/// count, so that nothing darkens toward the edges of charts.
TransferRows coarserRows(const TextureLevel& level, const TransferRows& finer);

/// An evaluated texture, row y * width upward.
struct LightTexture {
  int width = 0, height = 0;
  std::vector<vec3> texels;
  /// Bilinear at a place in this level's texels (texel (i, j) covers [i, i+1] x [j, j+1]); clamped
  /// to the texture. Inside of charts no empty texel has any share.
  [[nodiscard]] vec3 at(const vec2& place) const;
};

/// Spreads the items' values over the texels. Empty ones get `empty`, which diagnostics may colour.
LightTexture paint(const TextureLevel& level, std::span<const vec3> values,
                   const vec3& empty = vec3(0.0F));

}  // namespace soffit::prt

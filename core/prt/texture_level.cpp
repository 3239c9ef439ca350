// SPDX-License-Identifier: MIT
#include "core/prt/texture_level.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace soffit::prt {
namespace {

/// Rings of texels around what is there, each taking the item of a neighbor: beside before above,
/// those before corners.
void dilate(TextureLevel& level, int rings) {
  constexpr int kAround[8][2] = {{-1, 0},  {1, 0},  {0, -1}, {0, 1},
                                 {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) +
           static_cast<std::size_t>(x);
  };
  std::vector<std::size_t> front;
  for (const std::uint32_t t : level.texel) front.push_back(t);
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<std::pair<std::size_t, std::uint32_t>> found;
    for (const std::size_t t : front) {
      const int x = static_cast<int>(t % static_cast<std::size_t>(level.width));
      const int y = static_cast<int>(t / static_cast<std::size_t>(level.width));
      for (const auto& d : kAround) {
        const int nx = x + d[0];
        const int ny = y + d[1];
        if (nx < 0 || ny < 0 || nx >= level.width || ny >= level.height) continue;
        if (level.item[at(nx, ny)] == kNoReceiver) found.emplace_back(at(nx, ny), level.item[t]);
      }
    }
    front.clear();
    for (const auto& [texel, item] : found) {
      if (level.item[texel] != kNoReceiver) continue;
      level.item[texel] = item;
      level.kind[texel] = TexelKind::dilated;
      front.push_back(texel);
    }
  }
}

}  // namespace

TextureLevel finestLevel(int width, int height, std::vector<std::uint32_t> texels,
                         std::vector<float> areas, int dilation) {
  TextureLevel level;
  level.width = width;
  level.height = height;
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  level.item.assign(count, kNoReceiver);
  level.kind.assign(count, TexelKind::empty);
  level.texel = std::move(texels);
  level.area = std::move(areas);
  for (std::uint32_t k = 0; k < level.texel.size(); ++k) {
    level.item[level.texel[k]] = k;
    level.kind[level.texel[k]] = TexelKind::covered;
  }
  dilate(level, dilation);
  return level;
}

TextureLevel coarserLevel(const TextureLevel& finer, int dilation) {
  const int width = (finer.width + 1) / 2;
  const int height = (finer.height + 1) / 2;
  std::vector<std::uint32_t> texels;
  std::vector<float> areas;
  std::vector<std::uint32_t> first{0};
  std::vector<Tap> children;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      float area = 0.0F;
      for (int k = 0; k < 4; ++k) {
        const int fx = 2 * x + k % 2;
        const int fy = 2 * y + k / 2;
        if (fx >= finer.width || fy >= finer.height) continue;
        const auto at = static_cast<std::size_t>(fy * finer.width + fx);
        if (finer.kind[at] != TexelKind::covered) continue;
        children.push_back({finer.item[at], finer.area[finer.item[at]]});
        area += finer.area[finer.item[at]];
      }
      if (children.size() == first.back()) continue;
      for (std::size_t c = first.back(); c < children.size(); ++c) children[c].weight /= area;
      first.push_back(static_cast<std::uint32_t>(children.size()));
      texels.push_back(static_cast<std::uint32_t>(y * width + x));
      areas.push_back(area);
    }
  }
  TextureLevel level = finestLevel(width, height, std::move(texels), std::move(areas), dilation);
  level.first = std::move(first);
  level.children = std::move(children);
  return level;
}

TransferRows coarserRows(const TextureLevel& level, const TransferRows& finer) {
  TransferRows rows(level.items(), finer.bands(), finer.channels());
  for (std::size_t k = 0; k < level.items(); ++k) {
    const std::span<const Tap> taps(level.children.data() + level.first[k],
                                    level.first[k + 1] - level.first[k]);
    addRows(finer.data(), finer.stride(), taps, rows.row(k).data());
  }
  return rows;
}

vec3 LightTexture::at(const vec2& place) const {
  const float x = std::clamp(place.x - 0.5F, 0.0F, static_cast<float>(width - 1));
  const float y = std::clamp(place.y - 0.5F, 0.0F, static_cast<float>(height - 1));
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, width - 1);
  const int y1 = std::min(y0 + 1, height - 1);
  const auto texel = [&](int i, int j) { return texels[static_cast<std::size_t>(j * width + i)]; };
  const float fx = x - static_cast<float>(x0);
  const float fy = y - static_cast<float>(y0);
  return glm::mix(glm::mix(texel(x0, y0), texel(x1, y0), fx),
                  glm::mix(texel(x0, y1), texel(x1, y1), fx), fy);
}

LightTexture paint(const TextureLevel& level, std::span<const vec3> values, const vec3& empty) {
  assert(values.size() >= level.items());
  LightTexture texture{level.width, level.height, {}};
  texture.texels.reserve(level.item.size());
  for (const std::uint32_t item : level.item) {
    texture.texels.push_back(item == kNoReceiver ? empty : values[item]);
  }
  return texture;
}

}  // namespace soffit::prt

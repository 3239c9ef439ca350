// SPDX-License-Identifier: MIT
#include "core/render/mip_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::render {
namespace {

int wrapped(int i, int n) {
  const int r = i % n;
  return r < 0 ? r + n : r;
}

}  // namespace

MipMap::MipMap(const scene::Image& image) {
  assert(image.channels == 3 && image.width > 0 && image.height > 0);
  Level full{image.width, image.height, {}};
  full.texels.resize(image.pixels.size() / 3);
  for (std::size_t i = 0; i < full.texels.size(); ++i) {
    full.texels[i] = {image.pixels[3 * i], image.pixels[3 * i + 1], image.pixels[3 * i + 2]};
  }
  levels_.push_back(std::move(full));
  while (levels_.back().width > 1 || levels_.back().height > 1)
    levels_.push_back(halved(levels_.back()));
}

MipMap::Level MipMap::halved(const Level& level) {
  Level half{std::max(level.width / 2, 1), std::max(level.height / 2, 1), {}};
  half.texels.reserve(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  for (int y = 0; y < half.height; ++y) {
    const int y0 = y * level.height / half.height;
    const int y1 = std::max((y + 1) * level.height / half.height, y0 + 1);
    for (int x = 0; x < half.width; ++x) {
      const int x0 = x * level.width / half.width;
      const int x1 = std::max((x + 1) * level.width / half.width, x0 + 1);
      vec3 sum(0.0F);
      for (int j = y0; j < y1; ++j)
        for (int i = x0; i < x1; ++i)
          sum += level.texels[static_cast<std::size_t>(j * level.width + i)];
      half.texels.push_back(sum / static_cast<float>((y1 - y0) * (x1 - x0)));
    }
  }
  return half;
}

vec3 MipMap::Level::bilinear(const vec2& uv) const {
  const float x = (uv.x - std::floor(uv.x)) * static_cast<float>(width) - 0.5F;
  const float y = (1.0F - (uv.y - std::floor(uv.y))) * static_cast<float>(height) - 0.5F;
  const float fx = std::floor(x);
  const float fy = std::floor(y);
  const int x0 = wrapped(static_cast<int>(fx), width);
  const int y0 = wrapped(static_cast<int>(fy), height);
  const int x1 = x0 + 1 == width ? 0 : x0 + 1;
  const int y1 = y0 + 1 == height ? 0 : y0 + 1;
  const auto texel = [&](int i, int j) { return texels[static_cast<std::size_t>(j * width + i)]; };
  return glm::mix(glm::mix(texel(x0, y0), texel(x1, y0), x - fx),
                  glm::mix(texel(x0, y1), texel(x1, y1), x - fx), y - fy);
}

vec3 MipMap::at(const vec2& uv, float width) const {
  const vec2 place = std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : vec2(0.0F);
  const float top = static_cast<float>(levels_.size() - 1);
  const float lod = std::clamp(std::log2(std::max(width, 1.0F)), 0.0F, top);
  const auto lower = static_cast<std::size_t>(lod);
  const vec3 fine = levels_[lower].bilinear(place);
  const float rest = lod - static_cast<float>(lower);
  if (rest <= 0.0F || lower + 1 >= levels_.size()) return fine;
  return glm::mix(fine, levels_[lower + 1].bilinear(place), rest);
}

vec2 MipMap::size() const {
  return {levels_[0].width, levels_[0].height};
}

}  // namespace soffit::render

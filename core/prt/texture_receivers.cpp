// SPDX-License-Identifier: MIT
#include "core/prt/texture_receivers.h"

#include "core/prt/material_maps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::prt {
namespace {

std::vector<std::uint32_t> objectsOf(const Surfaces& s, std::vector<std::string>& names) {
  names = s.mesh->objects;
  std::vector<std::uint32_t> set_of(s.triangleCount(), 0);
  for (std::size_t t = 0; t < set_of.size() && t < s.mesh->object_of.size(); ++t) {
    set_of[t] = s.mesh->object_of[t];
    if (set_of[t] >= names.size()) names.resize(set_of[t] + 1);
  }
  if (names.empty()) names.emplace_back();
  return set_of;
}

}  // namespace

TextureReceivers::TextureReceivers(std::shared_ptr<const Surfaces> surfaces,
                                   std::vector<std::uint32_t> set_of,
                                   const std::vector<std::string>& names,
                                   const TextureOptions& options, const Job& job)
    : surfaces_(std::move(surfaces)), set_of_(std::move(set_of)) {
  local_.assign(surfaces_->triangleCount(), kNoReceiver);
  std::vector<std::vector<std::uint32_t>> triangles(names.size());
  for (std::uint32_t t = 0; t < set_of_.size(); ++t) triangles[set_of_[t]].push_back(t);
  for (std::size_t k = 0; k < names.size(); ++k) addSet(names[k], triangles[k], options, job);
}

TextureReceivers TextureReceivers::perObject(std::shared_ptr<const Surfaces> surfaces,
                                             const TextureOptions& options, const Job& job) {
  std::vector<std::string> names;
  std::vector<std::uint32_t> set_of = objectsOf(*surfaces, names);
  return {std::move(surfaces), std::move(set_of), names, options, job};
}

TextureReceivers TextureReceivers::atlas(std::shared_ptr<const Surfaces> surfaces,
                                         const TextureOptions& options, const Job& job) {
  const std::size_t triangles = surfaces->triangleCount();
  return {std::move(surfaces), std::vector<std::uint32_t>(triangles, 0), {"atlas"}, options, job};
}

void TextureReceivers::addSet(const std::string& name, const std::vector<std::uint32_t>& triangles,
                              const TextureOptions& options, const Job& job) {
  TextureSet set;
  set.name = name;
  set.layout = layOut(*surfaces_, triangles, options);
  set.first = static_cast<std::uint32_t>(receivers_.size());
  for (std::uint32_t i = 0; i < set.layout.triangles.size(); ++i) {
    local_[set.layout.triangles[i]] = i;
  }
  std::vector<std::uint32_t> texels;
  std::vector<float> areas;
  for (const RasterTexel& texel : rasterize(*surfaces_, set.layout, job)) {
    if (job.cancelled()) break;
    addReceiver(texel, set.layout.texel);
    texels.push_back(texel.texel);
    areas.push_back(texel.area);
  }
  set.count = static_cast<std::uint32_t>(texels.size());
  set.levels.push_back(finestLevel(set.layout.width, set.layout.height, std::move(texels),
                                   std::move(areas), options.dilation));
  for (int k = 1; k < options.levels; ++k) {
    set.levels.push_back(coarserLevel(set.levels.back(), options.dilation));
  }
  sets_.push_back(std::move(set));
}

void TextureReceivers::addReceiver(const RasterTexel& texel, double width) {
  const Surfaces& s = *surfaces_;
  const MapPlace place{texel.triangle, texel.u, texel.v, static_cast<float>(width)};
  const float sign = texel.front ? 1.0F : -1.0F;
  const vec3& a = s.corner(texel.triangle, 0);
  receivers_.positions.push_back(a + texel.u * (s.corner(texel.triangle, 1) - a) +
                                 texel.v * (s.corner(texel.triangle, 2) - a));
  receivers_.facing.push_back(sign * s.normals[texel.triangle]);
  receivers_.normals.push_back(sign * shadingNormalAt(s, place));
  receivers_.reflectance.push_back(reflectanceAt(s, place));
  receivers_.areas.push_back(texel.area);
  chart_of_.push_back(texel.chart);
}

bool TextureReceivers::find(const geometry::Hit& hit, bool front, vec2& place,
                            std::uint32_t& chart) const {
  const std::uint32_t i = local_[hit.triangle];
  if (i == kNoReceiver) return false;
  const TextureLayout& layout = sets_[set_of_[hit.triangle]].layout;
  const std::size_t side = front ? 0 : 1;
  chart = layout.chart_of[side][i];
  if (chart == TextureLayout::kNoChart) return false;
  const auto& c = layout.corners[side][i];
  place = (1.0F - hit.u - hit.v) * c[0] + hit.u * c[1] + hit.v * c[2];
  return true;
}

bool TextureReceivers::place(const geometry::Hit& hit, bool front, vec2& out) const {
  std::uint32_t chart = 0;
  return find(hit, front, out, chart);
}

std::size_t TextureReceivers::around(const geometry::Hit& hit, bool front, Around& taps) const {
  vec2 p;
  std::uint32_t chart = 0;
  if (!find(hit, front, p, chart)) return 0;
  const TextureSet& set = sets_[set_of_[hit.triangle]];
  const TextureLevel& level = set.levels.front();
  const vec2 q = p - 0.5F;
  const vec2 base = glm::floor(q);
  const vec2 f = q - base;
  std::size_t count = 0;
  float sum = 0.0F;
  for (int k = 0; k < 4; ++k) {
    const int x = static_cast<int>(base.x) + k % 2;
    const int y = static_cast<int>(base.y) + k / 2;
    if (x < 0 || y < 0 || x >= level.width || y >= level.height) continue;
    const auto at = static_cast<std::size_t>(y * level.width + x);
    if (level.kind[at] != TexelKind::covered) continue;
    const std::uint32_t receiver = set.first + level.item[at];
    const float weight = (k % 2 == 1 ? f.x : 1.0F - f.x) * (k / 2 == 1 ? f.y : 1.0F - f.y);
    if (chart_of_[receiver] != chart || weight <= 0.0F) continue;
    taps[count++] = {receiver, weight};
    sum += weight;
  }
  for (std::size_t k = 0; k < count; ++k) taps[k].weight /= sum;
  if (count > 0) return count;
  // A sliver that was left out: the texel next to it.
  const int x = std::clamp(static_cast<int>(p.x), 0, level.width - 1);
  const int y = std::clamp(static_cast<int>(p.y), 0, level.height - 1);
  const std::uint32_t item = level.item[static_cast<std::size_t>(y * level.width + x)];
  if (item == kNoReceiver) return 0;
  taps[0] = {set.first + item, 1.0F};
  return 1;
}

std::vector<std::uint32_t> TextureReceivers::nearestValid(
    std::span<const std::uint8_t> valid) const {
  std::vector<std::uint32_t> offsets{0};
  std::vector<std::uint32_t> neighbors;
  for (const TextureSet& set : sets_) {
    const TextureLevel& level = set.levels.front();
    for (std::uint32_t k = 0; k < set.count; ++k) {
      const int x = static_cast<int>(level.texel[k]) % level.width;
      const int y = static_cast<int>(level.texel[k]) / level.width;
      for (const auto& d :
           {glm::ivec2(-1, 0), glm::ivec2(1, 0), glm::ivec2(0, -1), glm::ivec2(0, 1)}) {
        const int nx = x + d.x;
        const int ny = y + d.y;
        if (nx < 0 || ny < 0 || nx >= level.width || ny >= level.height) continue;
        const auto at = static_cast<std::size_t>(ny * level.width + nx);
        if (level.kind[at] != TexelKind::covered) continue;
        const std::uint32_t other = set.first + level.item[at];
        if (chart_of_[other] == chart_of_[set.first + k]) neighbors.push_back(other);
      }
      offsets.push_back(static_cast<std::uint32_t>(neighbors.size()));
    }
  }
  return spreadFromValid(valid, offsets, neighbors);
}

}  // namespace soffit::prt

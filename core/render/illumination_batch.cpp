// SPDX-License-Identifier: MIT
#include "core/render/illumination_batch.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

float clean(float v) {
  return std::isfinite(v) && v > 0.0F ? v : 0.0F;
}

}  // namespace

void IlluminationBatch::clear() {
  points_.clear();
  order_.clear();
}

std::uint32_t IlluminationBatch::add(const SurfacePoint& point, std::uint32_t surface) {
  const auto index = static_cast<std::uint32_t>(points_.size());
  points_.push_back(point);
  order_.push_back(static_cast<std::uint64_t>(surface) << 32U | index);
  return index;
}

void IlluminationBatch::run(const Illumination& illumination) {
  const std::size_t count = points_.size();
  totals_.resize(count);
  if (count == 0) return;
  std::sort(order_.begin(), order_.end());
  sorted_.clear();
  for (const std::uint64_t key : order_) sorted_.push_back(points_[key & 0xffffffffU]);
  direct_.assign(count, vec3(0.0F));
  indirect_.assign(count, vec3(0.0F));
  illumination.evaluate(sorted_, direct_, indirect_);
  for (std::size_t i = 0; i < count; ++i) {
    const vec3 sum = direct_[i] + indirect_[i];
    totals_[order_[i] & 0xffffffffU] = {clean(sum.x), clean(sum.y), clean(sum.z)};
  }
}

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#include "core/transfer/far_blocks.h"

#include "core/math/box.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soffit::transfer {
namespace {

/// A block may be as large as what so many rays stand for. With 4 as with 16 no error on surfaces
/// of the samples differs from that of texels by more than its own noise; 16 makes lists 10 to 15 %
/// shorter.
constexpr float kRays = 16.0F;
/// ... and no wider than this share of the distance, however flat it is seen.
constexpr float kWidest = 0.35F;

}  // namespace

FarBlocks::FarBlocks(const Texels& texels, std::span<const float> area)
    : slots_(area.size()), of_four_(slots_, 0.25F), of_sixteen_(slots_ / 4, 0.25F) {
  std::vector<double> fours(slots_ / 4);
  for (std::size_t k = 0; k < fours.size(); ++k) {
    for (std::size_t s = 4 * k; s < 4 * k + 4; ++s) fours[k] += static_cast<double>(area[s]);
    extents_.push_back(extentOf(texels, area, 4 * k, 4));
    if (fours[k] <= 0.0) continue;
    for (std::size_t s = 4 * k; s < 4 * k + 4; ++s) {
      of_four_[s] = static_cast<float>(static_cast<double>(area[s]) / fours[k]);
    }
  }
  for (std::size_t k = 0; k < slots_ / 16; ++k) {
    double whole = 0.0;
    for (std::size_t f = 4 * k; f < 4 * k + 4; ++f) whole += fours[f];
    extents_.push_back(extentOf(texels, area, 16 * k, 16));
    if (whole <= 0.0) continue;
    for (std::size_t f = 4 * k; f < 4 * k + 4; ++f) {
      of_sixteen_[f] = static_cast<float>(fours[f] / whole);
    }
  }
}

FarBlocks::Extent FarBlocks::extentOf(const Texels& texels, std::span<const float> area,
                                      std::size_t begin, std::size_t count) const {
  Extent out;
  Box box;
  std::size_t first = slots_;
  double sum = 0.0;
  for (std::size_t s = begin; s < begin + count; ++s) {
    if (area[s] <= 0.0F) continue;
    if (first == slots_) first = s;
    // Texels of two parts may be as good as in two rooms; what looks elsewhere sees other points.
    const bool alike = texels.openness[s] != 0 && texels.part[s] == texels.part[first] &&
                       texels.openness[s] == texels.openness[first] &&
                       texels.charts.chart_of[texels.triangle[s]] ==
                           texels.charts.chart_of[texels.triangle[first]] &&
                       glm::dot(texels.receivers.normal(s), texels.receivers.normal(first)) > 0.95F;
    if (!alike) return {};
    box.add(texels.receivers.position(s));
    sum += static_cast<double>(area[s]);
  }
  if (sum <= 0.0) return {};
  out.area = static_cast<float>(sum);
  // From the outermost texels' points to their borders.
  out.diagonal = box.diagonal() + std::sqrt(static_cast<float>(sum / static_cast<double>(count)));
  if (out.diagonal * out.diagonal > 6.0F * out.area) return {};
  return out;
}

void FarBlocks::stepBack(const Texels& texels, const vec3& p, const vec3& n, float share,
                         std::span<std::uint32_t> ends) const {
  for (std::uint32_t& end : ends) {
    if (end == kNoTexel) continue;
    const vec3 to = texels.receivers.position(end) - p;
    const float d2 = glm::dot(to, to);
    if (d2 <= 0.0F) continue;
    const float d = std::sqrt(d2);
    // Cosine-distributed rays stand for pi / N = dA cos cos' / d^2 each.
    const float cosines =
        std::abs(glm::dot(to, n) * glm::dot(to, texels.receivers.normal(end))) / d2;
    const float footprint = kRays * std::numbers::pi_v<float> * share * d2;
    for (const int level : {2, 1}) {
      const std::size_t block = index(level, end);
      const Extent& extent = extents_[block - slots_];
      if (extent.area * cosines > footprint || extent.diagonal > kWidest * d) continue;
      end = static_cast<std::uint32_t>(block);
      break;
    }
  }
}

void FarBlocks::average(std::size_t begin, std::size_t end, std::size_t channels,
                        std::span<float> field) const {
  const auto mean = [&](std::size_t from, std::size_t to, std::span<const float> shares) {
    for (std::size_t c = 0; c < channels; ++c) {
      float sum = 0.0F;
      for (std::size_t k = 0; k < 4; ++k) sum += shares[k] * field[(from + k) * channels + c];
      field[to * channels + c] = sum;
    }
  };
  for (std::size_t s = begin; s < end; s += 4) {
    mean(s, index(1, s), std::span(of_four_).subspan(s, 4));
  }
  for (std::size_t s = begin; s < end; s += 16) {
    mean(index(1, s), index(2, s), std::span(of_sixteen_).subspan(s / 4, 4));
  }
}

void FarBlocks::average(std::size_t begin, std::size_t end, std::span<vec4> field) const {
  const auto mean = [&](const vec4* x, const float* share) {
    return share[0] * x[0] + share[1] * x[1] + share[2] * x[2] + share[3] * x[3];
  };
  for (std::size_t s = begin; s < end; s += 4) {
    field[index(1, s)] = mean(&field[s], &of_four_[s]);
  }
  for (std::size_t s = begin; s < end; s += 16) {
    field[index(2, s)] = mean(&field[index(1, s)], &of_sixteen_[s / 4]);
  }
}

}  // namespace soffit::transfer

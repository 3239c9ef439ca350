// SPDX-License-Identifier: MIT
#include "core/light/box_tree.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace soffit::light {
namespace {

constexpr std::uint32_t kWidth = BoxBlock::kSize;

void orderRange(std::span<const vec3> centers, std::vector<std::uint32_t>& order,
                std::uint32_t begin, std::uint32_t end) {
  const std::uint32_t count = end - begin;
  if (count <= kWidth) return;
  std::uint32_t unit = kWidth;
  while (unit <= (count - 1) / kWidth) unit *= kWidth;
  const std::uint32_t units = (count + unit - 1) / unit;
  const std::uint32_t middle = begin + units / 2 * unit;
  Box box;
  for (std::uint32_t i = begin; i < end; ++i) box.add(centers[order[i]]);
  const vec3 size = box.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const float ka = centers[a][axis];
                     const float kb = centers[b][axis];
                     return ka < kb || (ka == kb && a < b);
                   });
  orderRange(centers, order, begin, middle);
  orderRange(centers, order, middle, end);
}

std::vector<BoxBlock> blocksOf(std::span<const Box> boxes) {
  std::vector<BoxBlock> blocks((boxes.size() + kWidth - 1) / kWidth);
  for (std::size_t i = 0; i < boxes.size(); ++i) blocks[i / kWidth].set(i % kWidth, boxes[i]);
  return blocks;
}

}  // namespace

std::vector<std::uint32_t> orderByPlace(std::span<const vec3> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  orderRange(points, order, 0, static_cast<std::uint32_t>(points.size()));
  return order;
}

BoxTree::BoxTree(std::span<const Box> boxes) {
  std::vector<Box> level(boxes.begin(), boxes.end());
  while (!level.empty()) {
    levels_.push_back(blocksOf(level));
    if (level.size() <= kWidth) return;
    std::vector<Box> next((level.size() + kWidth - 1) / kWidth);
    for (std::size_t i = 0; i < level.size(); ++i) next[i / kWidth].add(level[i]);
    level = std::move(next);
  }
}

void BoxTree::visit(std::size_t level, std::size_t block, const Shaft& shaft,
                    std::vector<Part>& out) const {
  std::uint32_t bits = cullBoxes(levels_[level][block], shaft.planes());
  if (bits == 0) return;
  if (level == 0) {
    out.push_back({static_cast<std::uint32_t>(block), bits});
    return;
  }
  for (; bits != 0; bits &= bits - 1) {
    visit(level - 1, block * kWidth + static_cast<std::size_t>(std::countr_zero(bits)), shaft, out);
  }
}

void BoxTree::collect(const Shaft& shaft, std::vector<Part>& out) const {
  if (!levels_.empty()) visit(levels_.size() - 1, 0, shaft, out);
}

}  // namespace soffit::light

// SPDX-License-Identifier: MIT
#include "core/light/blockers.h"

#include <algorithm>
#include <numeric>

namespace soffit::light {

namespace {
constexpr std::uint32_t kLeafSize = 6;
}

Blockers::Blockers(std::vector<Blocker> blockers) : blockers_(std::move(blockers)) {
  std::vector<Box> boxes;
  boxes.reserve(blockers_.size());
  for (const Blocker& b : blockers_) {
    boxes.push_back(b.bounds());
    bounds_.add(boxes.back());
  }
  if (!blockers_.empty()) {
    nodes_.reserve(blockers_.size());
    build(0, static_cast<std::uint32_t>(blockers_.size()), boxes);
  }
}

void Blockers::build(std::uint32_t begin, std::uint32_t end, std::vector<Box>& boxes) {
  const std::size_t index = nodes_.size();
  nodes_.emplace_back();
  Box box;
  Box centers;
  for (std::uint32_t i = begin; i < end; ++i) {
    box.add(boxes[i]);
    centers.add(boxes[i].center());
  }
  nodes_[index].box = box;
  const vec3 size = centers.size();
  if (end - begin <= kLeafSize || std::max({size.x, size.y, size.z}) <= 0.0F) {
    nodes_[index].first = begin;
    nodes_[index].count = end - begin;
    return;
  }
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  // Median split of a permutation, applied to both arrays; ties are broken by index so that the
  // tree is the same on every platform.
  std::vector<std::uint32_t> order(end - begin);
  std::iota(order.begin(), order.end(), begin);
  const std::uint32_t half = (end - begin) / 2;
  std::nth_element(order.begin(), order.begin() + half, order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const float ca = boxes[a].center()[axis];
    const float cb = boxes[b].center()[axis];
    return ca < cb || (ca == cb && a < b);
  });
  std::vector<Blocker> moved_blockers;
  std::vector<Box> moved_boxes;
  moved_blockers.reserve(order.size());
  moved_boxes.reserve(order.size());
  for (const std::uint32_t i : order) {
    moved_blockers.push_back(blockers_[i]);
    moved_boxes.push_back(boxes[i]);
  }
  std::copy(moved_blockers.begin(), moved_blockers.end(), blockers_.begin() + begin);
  std::copy(moved_boxes.begin(), moved_boxes.end(), boxes.begin() + begin);
  build(begin, begin + half, boxes);
  nodes_[index].first = static_cast<std::uint32_t>(nodes_.size());
  build(begin + half, end, boxes);
}

void Blockers::collect(const Shaft& shaft, std::vector<std::uint32_t>& out) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, 64> stack{};
  int depth = 0;
  stack[static_cast<std::size_t>(depth++)] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[static_cast<std::size_t>(--depth)];
    const Node& node = nodes_[index];
    if (!shaft.touches(node.box)) continue;
    if (node.count > 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        if (shaft.touches(blockers_[i].outline())) out.push_back(i);
      }
    } else {
      stack[static_cast<std::size_t>(depth++)] = node.first;
      stack[static_cast<std::size_t>(depth++)] = index + 1;
    }
  }
}

}  // namespace soffit::light

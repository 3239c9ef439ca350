// SPDX-License-Identifier: MIT
#include "core/light/blockers.h"

#include <algorithm>
#include <bit>

namespace soffit::light {
namespace {

std::vector<MaskBlocker> maskBlockers(std::span<const Blocker> blockers) {
  std::vector<MaskBlocker> out;
  out.reserve(blockers.size());
  for (const Blocker& b : blockers) out.push_back(maskBlocker(b));
  return out;
}

Box boundsOf(const MaskBlocker& blocker) {
  Box box;
  for (int k = 0; k < blocker.count; ++k) box.add(blocker.corners[static_cast<std::size_t>(k)]);
  return box;
}

}  // namespace

Blockers::Blockers(std::span<const Blocker> blockers) : Blockers(maskBlockers(blockers)) {}

Blockers::Blockers(std::span<const MaskBlocker> blockers) : size_(blockers.size()) {
  std::vector<vec3> centers;
  centers.reserve(blockers.size());
  for (const MaskBlocker& b : blockers) centers.push_back(boundsOf(b).center());
  std::vector<Box> boxes;
  std::size_t k = 0;
  for (const std::uint32_t i : orderByPlace(centers)) {
    if (k % BlockerLanes::kBlock == 0) {
      blocks_.emplace_back();
      boxes.emplace_back();
    }
    putBlocker(blockers[i], blocks_.back().rows[0].data() + k % BlockerLanes::kBlock,
               BlockerLanes::kBlock);
    boxes.back().add(boundsOf(blockers[i]));
    five_ = five_ || blockers[i].count > 4;
    ++k;
  }
  tree_ = BoxTree(boxes);
}

void Blockers::collect(const Shaft& shaft, BlockerLanes& out) const {
  std::vector<BoxTree::Part> parts;
  tree_.collect(shaft, parts);
  const BlockerFilter filter{shaft.hull(), shaft.slopes(), shaft.from(), shaft.to(), nullptr};
  if (five_) out.markFive();
  for (const BoxTree::Part& part : parts) {
    for (std::uint32_t bits = part.bits; bits != 0; bits &= bits - 1) {
      filterBlock(blocks_[part.index(std::countr_zero(bits))], five_, filter, out);
    }
  }
}

MaskBlocker maskBlocker(const Blocker& blocker) {
  MaskBlocker m;
  std::copy(blocker.corners.begin(), blocker.corners.end(), m.corners.begin());
  m.count = blocker.count;
  m.normal = blocker.normal;
  m.d = glm::dot(blocker.normal, blocker.corners[0]);
  m.solid = blocker.solid;
  return m;
}

}  // namespace soffit::light

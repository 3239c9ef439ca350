// SPDX-License-Identifier: MIT
#include "core/light/blockers.h"

#include <algorithm>
#include <bit>

namespace soffit::light {

namespace {

/// Lanes without a blocker never survive: their plane lies above everything.
CullBlock emptyBlock() {
  CullBlock block;
  block.d.fill(1.0F);
  return block;
}

void setLane(CullBlock& block, std::size_t k, const Blocker& blocker) {
  for (std::size_t c = 0; c < CullBlock::kCorners; ++c) {
    const vec3& corner = blocker.corners[std::min<std::size_t>(c, blocker.count - 1U)];
    block.x[c][k] = corner.x;
    block.y[c][k] = corner.y;
    block.z[c][k] = corner.z;
  }
  const vec3 n = blocker.solid ? blocker.normal : vec3(0.0F);
  block.nx[k] = n.x;
  block.ny[k] = n.y;
  block.nz[k] = n.z;
  block.d[k] = blocker.solid ? glm::dot(n, blocker.corners[0]) : -1.0F;
}

}  // namespace

Blockers::Blockers(std::span<const Blocker> blockers) {
  std::vector<vec3> centers;
  centers.reserve(blockers.size());
  for (const Blocker& b : blockers) centers.push_back(b.bounds().center());
  std::vector<Box> boxes;
  for (const std::uint32_t i : orderByPlace(centers)) {
    const std::size_t k = items_.size() % CullBlock::kSize;
    if (k == 0) {
      blocks_.push_back(emptyBlock());
      boxes.emplace_back();
    }
    setLane(blocks_.back(), k, blockers[i]);
    boxes.back().add(blockers[i].bounds());
    items_.push_back(maskBlocker(blockers[i]));
  }
  tree_ = BoxTree(boxes);
}

void Blockers::collect(const Shaft& shaft, std::vector<BoxTree::Part>& out) const {
  const std::size_t before = out.size();
  tree_.collect(shaft, out);
  // Whole walls have large boxes that most shafts meet: look at the blockers themselves.
  std::size_t kept = before;
  for (std::size_t i = before; i < out.size(); ++i) {
    BoxTree::Part part = out[i];
    for (std::uint32_t bits = part.bits; bits != 0; bits &= bits - 1) {
      const int bit = std::countr_zero(bits);
      const CullResult found =
          cullBlock(blocks_[part.index(bit)], shaft.planes(), shaft.from(), nullptr);
      if (found.whole == 0) part.bits &= ~(1U << static_cast<unsigned>(bit));
    }
    if (part.bits != 0) out[kept++] = part;
  }
  out.resize(kept);
}

void Blockers::find(std::span<const BoxTree::Part> parts, const Shaft& shaft, const Box& receivers,
                    const vec4* cut, Found& out) const {
  out.whole.clear();
  out.cut.clear();
  for (const BoxTree::Part& part : parts) {
    for (std::uint32_t bits = tree_.refine(part, shaft); bits != 0; bits &= bits - 1) {
      const std::size_t block = part.index(std::countr_zero(bits));
      const CullResult found = cullBlock(blocks_[block], shaft.planes(), receivers, cut);
      const MaskBlocker* const first = &items_[block * CullBlock::kSize];
      for (std::uint32_t b = found.whole; b != 0; b &= b - 1) {
        out.whole.push_back(first + std::countr_zero(b));
      }
      for (std::uint32_t b = found.cut; b != 0; b &= b - 1) {
        out.cut.push_back(first + std::countr_zero(b));
      }
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

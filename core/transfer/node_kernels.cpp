// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/transfer/node_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "core/base/parallel.h"
#include "core/transfer/kernels.h"
#include "core/transfer/node_kernels.h"
#include "core/transfer/rgb_lanes-inl.h"

#include <algorithm>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace soffit::transfer::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
constexpr D d;

void MultiplyNodes(const NodeMatrix& matrix, const float* x, float* y, std::size_t begin,
                   std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    // A sum for each of the nine coefficients: none waits for another within a block.
    auto s00 = zeroRgb(), s01 = zeroRgb(), s02 = zeroRgb();
    auto s10 = zeroRgb(), s11 = zeroRgb(), s12 = zeroRgb();
    auto s20 = zeroRgb(), s21 = zeroRgb(), s22 = zeroRgb();
    for (std::uint32_t k = matrix.first[i]; k < matrix.first[i + 1]; ++k) {
      const NodeMatrix::Block& block = matrix.blocks[k];
      const float* f = block.value.data();
      const float* from = x + 12 * static_cast<std::size_t>(block.sender);
      const auto x0 = loadRgb(from);
      const auto x1 = loadRgb(from + 4);
      const auto x2 = loadRgb(from + 8);
      s00 = mulAddRgb(f[0], x0, s00);
      s01 = mulAddRgb(f[1], x1, s01);
      s02 = mulAddRgb(f[2], x2, s02);
      s10 = mulAddRgb(f[3], x0, s10);
      s11 = mulAddRgb(f[4], x1, s11);
      s12 = mulAddRgb(f[5], x2, s12);
      s20 = mulAddRgb(f[6], x0, s20);
      s21 = mulAddRgb(f[7], x1, s21);
      s22 = mulAddRgb(f[8], x2, s22);
    }
    storeRgb(addRgb(s00, addRgb(s01, s02)), y + 12 * i);
    storeRgb(addRgb(s10, addRgb(s11, s12)), y + 12 * i + 4);
    storeRgb(addRgb(s20, addRgb(s21, s22)), y + 12 * i + 8);
  }
}

void MultiplyConstants(const ConstantMatrix& matrix, const float* x, float* y, std::size_t begin,
                       std::size_t end) {
  const auto from = [&](std::uint32_t k) {
    return loadRgb(x + 4 * static_cast<std::size_t>(matrix.sender[k]));
  };
  for (std::size_t i = begin; i < end; ++i) {
    auto s0 = zeroRgb(), s1 = zeroRgb(), s2 = zeroRgb(), s3 = zeroRgb();
    std::uint32_t k = matrix.first[i];
    const std::uint32_t last = matrix.first[i + 1];
    for (; k + 4 <= last; k += 4) {
      s0 = mulAddRgb(matrix.value[k], from(k), s0);
      s1 = mulAddRgb(matrix.value[k + 1], from(k + 1), s1);
      s2 = mulAddRgb(matrix.value[k + 2], from(k + 2), s2);
      s3 = mulAddRgb(matrix.value[k + 3], from(k + 3), s3);
    }
    for (; k < last; ++k) s0 = mulAddRgb(matrix.value[k], from(k), s0);
    storeRgb(addRgb(addRgb(s0, s1), addRgb(s2, s3)), y + 4 * i);
  }
}

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE void addEntry(const NodeLists::Entry& entry, const float* from, Rgb& s1, Rgb& s2) {
  s1 = mulAddRgb(entry.phi1, loadRgb(from + 4), s1);
  s2 = mulAddRgb(entry.phi2, loadRgb(from + 8), s2);
}
#else
HWY_INLINE void addEntry(const NodeLists::Entry& entry, const float* from, Rgb& s1, Rgb& s2) {
  // All four bytes at once; those of the gap are not used.
  const hn::Rebind<std::int8_t, Rgb4> bytes;
  const hn::Rebind<std::int32_t, Rgb4> words;
  const auto packed = hn::LoadU(bytes, reinterpret_cast<const std::int8_t*>(&entry));
  const Rgb v = hn::ConvertTo(Rgb4(), hn::PromoteTo(words, packed));
  s1 = hn::MulAdd(hn::Broadcast<2>(v), loadRgb(from + 4), s1);
  s2 = hn::MulAdd(hn::Broadcast<3>(v), loadRgb(from + 8), s2);
}
#endif

/// The linear functions; y holds the constants' share.
void AddLinear(const NodeLists& lists, std::size_t first, const float* b, float* y,
               std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const NodeLists::List& list = lists.lists[first + k];
    Rgb s1 = zeroRgb(), s2 = zeroRgb();
    const float* from = b;
    const NodeLists::Entry* entry = lists.entries.data() + list.first;
    const NodeLists::Entry* const end = entry + list.count;
    for (; entry < end; ++entry) {
      from += 12 * static_cast<std::size_t>(entry->gap);
      addEntry(*entry, from, s1, s2);
    }
    storeRgb(mulAddRgb(list.scale * NodeLists::kStep, addRgb(s1, s2), loadRgb(y + 4 * k)), y + 4 * k);
  }
}

/// out: 3 functions x (RGB + padding).
void RestrictSent(const float* area, const float* phi, const float* const* rho,
                  const float* const* e, std::size_t slots, float scale, float* out) {
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t c = 0; c < 3; ++c) {
    auto s0 = hn::Zero(d), s1 = hn::Zero(d), s2 = hn::Zero(d);
    for (std::size_t s = 0; s < slots; s += lanes) {
      const auto sent = hn::Mul(hn::Mul(hn::LoadU(d, area + s), hn::LoadU(d, rho[c] + s)),
                                hn::Max(hn::LoadU(d, e[c] + s), hn::Zero(d)));
      hn::Vec<D> u;
      hn::Vec<D> v;
      hn::LoadInterleaved2(d, phi + 2 * s, u, v);
      s0 = hn::Add(s0, sent);
      s1 = hn::MulAdd(sent, u, s1);
      s2 = hn::MulAdd(sent, v, s2);
    }
    out[c] = scale * hn::GetLane(hn::SumOfLanes(d, s0));
    out[4 + c] = scale * hn::GetLane(hn::SumOfLanes(d, s1));
    out[8 + c] = scale * hn::GetLane(hn::SumOfLanes(d, s2));
  }
}

}  // namespace soffit::transfer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace soffit::transfer {

HWY_EXPORT(MultiplyNodes);
HWY_EXPORT(MultiplyConstants);
HWY_EXPORT(AddLinear);
HWY_EXPORT(RestrictSent);

namespace {

/// Rows per piece of work, so that a piece has `wished` entries on average.
std::size_t rowsFor(std::size_t rows, std::size_t entries, std::size_t wished) {
  return std::max<std::size_t>(1, wished * rows / std::max<std::size_t>(1, entries));
}

}  // namespace

void multiplyNodes(const NodeMatrix& matrix, std::span<const PatchLight> x,
                   std::span<PatchLight> y) {
  if (y.empty()) return;
  parallelFor(y.size(), rowsFor(y.size(), matrix.blocks.size(), 8000),
              [&](std::size_t begin, std::size_t end) {
                HWY_DYNAMIC_DISPATCH(MultiplyNodes)
                (matrix, &x[0].c[0].x, &y[0].c[0].x, begin, end);
              });
}

ConstantMatrix constantsOf(const NodeMatrix& matrix) {
  ConstantMatrix out;
  out.first = matrix.first;
  for (const NodeMatrix::Block& block : matrix.blocks) {
    out.sender.push_back(block.sender);
    out.value.push_back(block.value[0]);
  }
  return out;
}

void multiplyConstants(const ConstantMatrix& matrix, std::span<const vec4> x, std::span<vec4> y) {
  if (y.empty()) return;
  // Below 0.1 ms a second thread would come too late.
  parallelFor(y.size(), rowsFor(y.size(), matrix.value.size(), 200000),
              [&](std::size_t begin, std::size_t end) {
                HWY_DYNAMIC_DISPATCH(MultiplyConstants)(matrix, &x[0].x, &y[0].x, begin, end);
              });
}

void gatherNodes(const NodeLists& lists, std::size_t first, std::span<const PatchLight> b,
                 std::span<const vec4> constants, std::span<vec4> y) {
  if (y.empty() || b.empty()) return;
  gather(lists.constants, first, constants, y);
  HWY_DYNAMIC_DISPATCH(AddLinear)(lists, first, &b[0].c[0].x, &y[0].x, y.size());
}

PatchLight restrictSent(const Nodes& nodes, const Nodes::Patch& patch, std::span<const float> area,
                        const std::array<std::span<const float>, 3>& rho,
                        const std::array<const float*, 3>& e) {
  PatchLight out;
  if (patch.area <= 0.0) return out;
  const std::array<const float*, 3> from = {&rho[0][patch.begin], &rho[1][patch.begin],
                                            &rho[2][patch.begin]};
  HWY_DYNAMIC_DISPATCH(RestrictSent)
  (&area[patch.begin], &nodes.phi[patch.begin].x, from.data(), e.data(), patch.end - patch.begin,
   static_cast<float>(1.0 / patch.area), &out.c[0].x);
  return out;
}

}  // namespace soffit::transfer
#endif

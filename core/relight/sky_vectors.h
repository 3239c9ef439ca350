// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/math/vec.h"
#include "core/relight/column.h"
#include "core/relight/sky_transfer.h"
#include "core/transfer/operators.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace soffit::relight {

/// Light at a slot that no sky changes, RGB lux; reflected light may be below 0, as it is
/// interpolated.
struct SlotRest {
  vec3 reflected{0.0F};
  vec3 direct{0.0F};
};
using SkyRest = std::vector<SlotRest>;
SkyRest skyRest(const Planes& reflected, const Planes& direct);

/// The transfer vectors of a sky per slot, in the form that a graphics processor takes them. With
/// R(k) and D(k) what a slot receives of function k reflected (RGB) and directly, and w =
/// SkyTransfer::weights(), its light is
///
///   max(0, max(0, rest.reflected + sum of w(k) R(k)) + rest.direct + sum of w(k) D(k)):
///
/// what spread() gives, and a step of a slider is that and nothing else.
///
/// Halves, four functions in four texels of four: the reflected light (r0 g0 b0 r1)(g1 b1 r2 g2)
/// (b2 r3 g3 b3), the direct light (d0 d1 d2 d3). Accuracy: a half is within 2^-11 of its value,
/// so the light is within 2^-11 of the sum of |w T|.
class SkyVectors {
 public:
  static constexpr std::size_t kFunctionsPerGroup = 4;
  static constexpr std::size_t kTexelsPerGroup = 4;
  /// Of packed().
  static constexpr std::size_t kWeightsPerGroup = 6;

  /// Null when cancelled. Takes two spread() per function.
  static std::shared_ptr<const SkyVectors> make(std::shared_ptr<const SkyTransfer> transfer,
                                                const transfer::Operators& operators,
                                                const Job& job);

  [[nodiscard]] const std::shared_ptr<const SkyTransfer>& transfer() const { return transfer_; }
  [[nodiscard]] std::size_t slots() const { return texels_.size() / (kTexelsPerGroup * groups_); }
  [[nodiscard]] std::size_t groups() const { return groups_; }
  /// Slot by slot, group by group, four halves each, as GL_RGBA16F has them.
  [[nodiscard]] std::span<const std::uint64_t> texels() const { return texels_; }
  /// SkyTransfer::weights() in that order, six per group: three for the products with the texels of
  /// reflected light, then the reds, greens and blues of the four functions.
  [[nodiscard]] std::vector<vec4> packed(std::span<const dvec3> weights) const;
  [[nodiscard]] std::size_t bytes() const { return texels_.size() * sizeof(std::uint64_t); }

  /// RGB lux per slot, as the formula above has it.
  [[nodiscard]] Planes evaluate(std::span<const dvec3> weights, const SkyRest& rest) const;

 private:
  SkyVectors() = default;
  void fill(std::size_t group, const transfer::Operators& operators);

  std::shared_ptr<const SkyTransfer> transfer_;
  std::size_t groups_ = 1;
  float scale_ = 1.0F;  ///< stored = T * scale: halves are few near 0
  std::vector<std::uint64_t> texels_;
};

}  // namespace soffit::relight

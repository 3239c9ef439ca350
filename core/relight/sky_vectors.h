// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/math/vec.h"
#include "core/relight/sky_transfer.h"
#include "core/transfer/operators.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace soffit::relight {

/// Points whose light is interpolated from texels: that of point p is the sum of weights[k] * light
/// of slots[k], k in first[p] .. first[p + 1]. The spans must live as long as this.
struct LightRows {
  std::span<const std::uint32_t> first;  ///< points + 1
  std::span<const std::uint32_t> slots;
  std::span<const float> weights;

  [[nodiscard]] std::size_t points() const { return first.empty() ? 0 : first.size() - 1; }
};

/// The transfer vectors of a sky at points, RGB per function, in the form that a graphics
/// processor takes them: light(p) = max(0, rest(p) + sum over k of weights[k] * T(p, k)), with
/// SkyTransfer::weights(). A step of a slider is that sum and nothing else.
///
/// Halves, four functions in three texels of four: (r0 g0 b0 r1)(g1 b1 r2 g2)(b2 r3 g3 b3).
/// Accuracy: a half is within 2^-12 of its value, so the light within 2^-12 of the sum of |weights
/// * T|. What is cut off at 0 is the sum at the point, where spread() cuts reflected light at the
/// texels.
class SkyVectors {
 public:
  static constexpr std::size_t kFunctionsPerGroup = 4;
  static constexpr std::size_t kTexelsPerGroup = 3;

  /// Null when cancelled. Takes a spread() per function.
  static std::shared_ptr<const SkyVectors> make(std::shared_ptr<const SkyTransfer> transfer,
                                                const transfer::Operators& operators,
                                                std::shared_ptr<const LightRows> rows,
                                                const Job& job);

  [[nodiscard]] const std::shared_ptr<const SkyTransfer>& transfer() const { return transfer_; }
  [[nodiscard]] const std::shared_ptr<const LightRows>& rows() const { return rows_; }
  [[nodiscard]] std::size_t points() const { return rows_->points(); }
  [[nodiscard]] std::size_t texelsPerPoint() const { return kTexelsPerGroup * groups_; }
  /// Per point texelsPerPoint() of four halves, as GL_RGBA16F has them.
  [[nodiscard]] std::span<const std::uint64_t> texels() const { return texels_; }
  /// SkyTransfer::weights() in the order of a point's texels, for their product.
  [[nodiscard]] std::vector<vec4> packed(std::span<const dvec3> weights) const;
  [[nodiscard]] std::size_t bytes() const { return texels_.size() * sizeof(std::uint64_t); }

  /// RGB lux of all points. rest: what is added, per point; empty: nothing.
  void evaluate(std::span<const dvec3> weights, std::span<const vec3> rest,
                std::span<vec3> out) const;

 private:
  SkyVectors() = default;

  std::shared_ptr<const SkyTransfer> transfer_;
  std::shared_ptr<const LightRows> rows_;
  std::size_t groups_ = 0;
  float scale_ = 1.0F;  ///< stored = T * scale: halves are few near 0
  std::vector<std::uint64_t> texels_;
};

/// RGB lux at points. out.size() == rows.points().
void lightPoints(const LightRows& rows, const Planes& lux, std::span<vec3> out);

}  // namespace soffit::relight

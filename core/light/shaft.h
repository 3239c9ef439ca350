// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/box.h"

#include <array>
#include <span>

namespace soffit::light {

/// The hull of two boxes as half-spaces n.x <= d (Haines & Wallace 1991, "Shaft Culling for
/// Efficient Ray-Traced Radiosity"): whatever lies outside one plane cannot block any segment
/// between the boxes. Surfaces that only touch a plane count as outside, so that the walls of an
/// empty room never enter the shafts between its surfaces.
class Shaft {
 public:
  /// Room for the hull (6 faces, at most 12 bridges) and a few planes of the caller.
  static constexpr int kMaxPlanes = 24;

  Shaft(const Box& from, const Box& to);

  /// Adds n.x <= d: things entirely on n.x >= d are outside.
  void addPlane(const vec3& n, float d);

  /// False when the box is certainly outside.
  [[nodiscard]] bool touches(const Box& box) const;
  /// False when all corners are outside (or on) one plane.
  [[nodiscard]] bool touches(std::span<const vec3> corners) const;

  [[nodiscard]] const Box& from() const { return from_; }
  [[nodiscard]] const Box& to() const { return to_; }
  /// The box about both, reduced by the tolerance: it stands for the first six planes.
  [[nodiscard]] Box hull() const {
    Box box;
    box.lo = {-planes_[1].w, -planes_[3].w, -planes_[5].w};
    box.hi = {planes_[0].w, planes_[2].w, planes_[4].w};
    return box;
  }
  /// All but those six.
  [[nodiscard]] std::span<const vec4> slopes() const { return planes().subspan(6); }
  /// (n, d): outside is n.x >= d, d already reduced by the tolerance.
  [[nodiscard]] std::span<const vec4> planes() const {
    return {planes_.data(), static_cast<std::size_t>(count_)};
  }

 private:
  Box from_;
  Box to_;
  std::array<vec4, kMaxPlanes> planes_{};  // (n, d), d already reduced by the tolerance
  int count_ = 0;
  float tolerance_ = 0.0F;
};

}  // namespace soffit::light

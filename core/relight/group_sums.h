// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/lighting.h"

#include <string>
#include <vector>

namespace soffit::relight {

/// The light of luminaires summed by group, so that dimming, switching or colouring a whole group
/// costs one multiplication per texel however many luminaires it has, and no ray.
///
/// Light is linear: while the weights (dimming times colour) of all members of a group change by
/// one factor per channel, the sum changes by it. Where few of them change, the difference is
/// added. Where most do, the members are mixed one by one, and summed again when that is asked for
/// a second time. Few members are never summed: they are as quick.
class GroupSums {
 public:
  /// Lux of all luminaires and of what shines in; names of their groups in the order of `lighting`'s emitters.
  /// changed: luminaires whose light itself is another since the last call (moved, reshaped).
  Planes total(const Lighting& lighting, const std::vector<std::string>& groups,
               const std::vector<bool>& changed);
  void clear() { sums_.clear(); }
  /// Luminaires that the last total() had to add up one by one.
  [[nodiscard]] std::size_t addedLast() const { return added_; }

 private:
  struct Sum {
    std::string group;
    std::vector<std::size_t> members;
    std::vector<dvec3> weights;  ///< with which the light was summed, or asked for last
    LightSum light;
    bool made = false;            ///< the light is there
    std::size_t differences = 0;  ///< that were added since: each leaves its rounding behind
  };
  bool adjust(Sum& sum, const Lighting& lighting, const std::vector<dvec3>& now);
  void make(Sum& sum, const Lighting& lighting);

  std::vector<Sum> sums_;
  std::size_t added_ = 0;
};

}  // namespace soffit::relight

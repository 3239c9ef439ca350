// SPDX-License-Identifier: MIT
#pragma once

#include "core/prt/directions.h"
#include "core/prt/receivers.h"
#include "core/prt/surfaces.h"
#include "core/prt/visibility_flags.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soffit::prt {

/// From which receivers, with which weights, the flagged directions of one receiver bring bounced
/// light. One per thread: it holds scratch memory.
class BounceTaps {
 public:
  BounceTaps(const Surfaces& surfaces, const ReceiverSet& from, const Directions& directions)
      : surfaces_(surfaces), from_(from), directions_(directions) {}

  /// What find() returns.
  enum class List {
    merged,       ///< one tap per sending receiver, ascending: for lists that are kept
    all,          ///< up to four per ray, in the order of the directions: half the time
    one_per_ray,  ///< one of those, drawn by weight from a fixed sequence: a quarter of the reading
  };
  /// Taps of receiver i of `to`; weights sum to the share of the cosine-weighted hemisphere that
  /// shows receiving sides. Valid until the next call.
  const std::vector<Tap>& find(const Receivers& to, const VisibilityFlags& flags, std::size_t i,
                               List list);

  [[nodiscard]] std::uint64_t rays() const { return rays_; }

 private:
  void add(const ReceiverSet::Around& around, std::size_t count, float weight, List list);
  void merge();

  const Surfaces& surfaces_;
  const ReceiverSet& from_;
  const Directions& directions_;
  std::vector<std::uint32_t> which_;
  std::vector<float> cosines_;
  std::vector<geometry::Ray> rays_of_;
  std::vector<geometry::Hit> hits_;
  std::vector<Tap> taps_;
  float choice_ = 0.5F;  ///< in [0, 1): of one_per_ray
  std::uint64_t rays_ = 0;
};

}  // namespace soffit::prt

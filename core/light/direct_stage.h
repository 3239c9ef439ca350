// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/blockers.h"
#include "core/light/prepared_light.h"
#include "core/light/receivers.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soffit::light {

/// Exact direct light of one luminaire at many points: closed form x bitmask visibility
/// (design.md section 3). Unoccluded error: round-off; visibility error: 512 samples on the light,
/// a jump of 1/512 where edges cross it.
struct DirectCounts {
  std::uint64_t points = 0;  ///< receivers evaluated (culled ones not counted)
  std::uint64_t clusters = 0;
  std::uint64_t clusters_culled = 0;  ///< behind the light, or the light behind them
  std::uint64_t clusters_clear = 0;   ///< empty shaft: nothing can block
  std::uint64_t groups_clear = 0;     ///< emptied by the finer shaft
  std::uint64_t blocker_tests = 0;    ///< blockers handed to the kernel, per group
  void add(const DirectCounts& o);
};

struct DirectOptions {
  float epsilon = 1e-4F;  ///< m; receivers nearer to a blocker's plane are not hidden by it
  /// The emitting luminaire's own body never blocks its light; others are listed here.
  std::span<const MaskBlocker> bodies;
  /// Where anything changed that may block: groups whose ways to the light touch none of these
  /// boxes keep the lux that they have. Empty: all are computed.
  std::span<const Box> changed;
  /// Per group, or empty: becomes 1 where it kept its lux.
  std::span<std::uint8_t> kept;
};

/// lux[slot] = illuminance at dimming 1 (Y of the colour = 1) for every slot of `receivers`;
/// lit[cluster] = 1 where any of it is not zero. Sizes: slotCount() and clusters.size(). Points
/// with normal (0,0,0) get 0.
/// Parallel over clusters; the result does not depend on the number of threads.
void directIlluminance(const PreparedLight& light, const Receivers& receivers,
                       const Blockers& blockers, const DirectOptions& options, std::span<float> lux,
                       std::span<std::uint8_t> lit, DirectCounts* counts = nullptr);

}  // namespace soffit::light

// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/prt/directions.h"
#include "core/prt/receivers.h"
#include "core/prt/surfaces.h"
#include "core/prt/transfer_rows.h"
#include "core/prt/visibility_flags.h"

#include <cstdint>
#include <vector>

/// The tutorial's third kind: light that comes after bounces, pass by pass (Fujita & Kanai 2004).
namespace soffit::prt {

struct BounceOptions {
  /// Passes end when one brings less than this share of pass 0, as RMS over the surface: what is
  /// left out is about rho / (1 - rho) of that. 1e-4 takes 14, 26, 42 passes at reflectance 0.5,
  /// 0.7, 0.8 in a closed room ("three or four" leave 3, 17, 33 % of the light out).
  double threshold = 1e-4;
  int most_passes = 500;
  /// Receivers and weights that the first pass found are kept up to so many bytes, and later passes
  /// trace nothing; beyond, every pass traces the flagged directions again.
  std::uint64_t keep_bytes = std::uint64_t{1} << 30U;
};

/// What a pass brought.
struct BouncePass {
  /// RMS over the surface, weighted by area, of the length of the transfer vectors it added (sr).
  double energy = 0.0;
  std::uint64_t rays = 0;
};

struct BouncedTransfer {
  TransferRows transfer;           ///< all passes together; 3 channels unless all is grey
  std::vector<BouncePass> passes;  ///< [0] is what came in
  std::uint64_t rays = 0;
  std::uint64_t kept_bytes = 0;  ///< of the first pass' finds; 0 when they were not kept
  bool converged = false;        ///< the threshold was reached before most_passes
};

/// Adds to direct transfer (one channel) what comes by diffuse bounces:
/// T^k(x) = sum over flagged directions of (w cos / sum of w cos) rho(y) T^(k-1)(y), y the place
/// that the ray meets, T^(k-1) interpolated between the receivers around it, sum over k.
///
/// Normalising by the directions' own sum of cosines makes the weights of a closed room's receiver
/// add up to 1, so that no light is made or lost. Sides that receive nothing are black. Sheets of
/// glass dim. Receivers that stand for another take its rows. The shading normal's cosine counts,
/// as it does for direct light.
///
/// direct  rows of set.receivers(), as shadowedTransfer() makes them.
/// Progress: "bounce k" with the energy in the observer's stage text. Errors: cancelled, within
/// about 0.1 s.
Result<BouncedTransfer> addBounces(const Surfaces& surfaces, const ReceiverSet& set,
                                   const Directions& directions, const VisibilityFlags& flags,
                                   const TransferRows& direct, const BounceOptions& options,
                                   const Job& job = {});

struct GatheredBounce {
  TransferRows transfer;
  std::uint64_t rays = 0;
};

/// One bounce only, from receivers that are solved already to others (a fine texture's texels from
/// coarse ones): direct + sum of rho(y) solved(y). A ray takes one of the receivers around its hit,
/// by weight: hundreds of rays interpolate well enough. Error: that of interpolating `solved`
/// between its receivers, softened by the reflection. Bands must be equal.
Result<GatheredBounce> gatherBounce(const Surfaces& surfaces, const ReceiverSet& from,
                                    const TransferRows& solved, const Receivers& to,
                                    const Directions& directions, const VisibilityFlags& flags,
                                    const TransferRows& direct, const Job& job = {});

}  // namespace soffit::prt

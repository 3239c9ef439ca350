// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/prt/directions.h"
#include "core/prt/receivers.h"
#include "core/prt/transfer_rows.h"
#include "core/prt/visibility_flags.h"

#include <cstdint>
#include <span>
#include <vector>

/// Transfer without bounces: of the tutorial's three kinds the first two.
namespace soffit::prt {

/// Light that meets nothing on its way: T_lm = A_l y_lm(n), the clamped cosine about the shading
/// normal in closed form (Ramamoorthi & Hanrahan 2001), to rounding. One channel; sr.
TransferRows unshadowedTransfer(const Receivers& receivers, int bands);

/// Light that is kept out by what the flags tell: T_lm = sum over open directions of
/// w y_lm(d) max(0, n . d), one channel, sr. No rays: new normals, or fewer bands, need no others.
///
/// What the directions miss of the whole cosine (closed form less their own sum) is added in
/// proportion to the share of the cosine-weighted hemisphere that is open, so that an open receiver
/// gets unshadowedTransfer() exactly and a shut one 0; the error left is that of the visible
/// part's outline: RMS of E about 1 % at 1024 directions behind half-open horizons (bench prt).
/// Receivers that stand for another get its row.
Result<TransferRows> shadowedTransfer(const Receivers& receivers, const Directions& directions,
                                      const VisibilityFlags& flags, const Job& job = {});

/// The same for the receivers with redo[i] != 0; the others' rows are those of `before`.
Result<TransferRows> shadowedTransfer(const Receivers& receivers, const Directions& directions,
                                      const VisibilityFlags& flags,
                                      std::span<const std::uint8_t> redo, TransferRows before,
                                      const Job& job = {});

/// Copies rows to the receivers that stand for another.
void copyFromSources(const Receivers& receivers, TransferRows& rows);

}  // namespace soffit::prt

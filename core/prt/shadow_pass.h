// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/math/box.h"
#include "core/prt/directions.h"
#include "core/prt/receivers.h"
#include "core/prt/surfaces.h"
#include "core/prt/visibility_flags.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

/// The rays of direct transfer: traced once, kept as flags.
namespace soffit::prt {

struct ShadowPass {
  VisibilityFlags flags;
  std::uint64_t rays = 0;
};

/// Traces every direction above each receiver's geometric horizon, from a point stepped off the
/// surface by geometry::offsetOrigin (not by the tutorial's absolute determinant and vertex
/// numbers). Directions behind the *shading* normal are traced too, so that normals may be edited
/// without a ray. Receivers that stand for another are left out. Sheets of glass in the way dim;
/// what they mirror is left out.
///
/// reach  m: what lies farther away blocks nothing, for lights in the room; else all of it does.
/// Errors: cancelled (within about 0.1 s).
Result<ShadowPass> traceShadows(const Surfaces& surfaces, const Receivers& receivers,
                                const Directions& directions, const Job& job = {},
                                float reach = std::numeric_limits<float>::infinity());

struct ShadowUpdate {
  VisibilityFlags flags;
  std::vector<std::uint8_t> changed;  ///< per receiver, whether any of its flags differ
  std::uint64_t rays = 0;
};

/// The same flags after an edit, for the rays alone that cross one of the `edited` boxes (bounds of
/// what was there before and of what is there now): no other ray can have changed. Equal to
/// traceShadows() of the new surfaces.
///
/// fresh  per receiver 1 where `flags` say nothing (another receiver was there): all its rays are
///        traced, and it counts as changed. Empty: none.
/// Errors: cancelled.
Result<ShadowUpdate> retraceShadows(const VisibilityFlags& flags, const Surfaces& surfaces,
                                    const Receivers& receivers, const Directions& directions,
                                    std::span<const Box> edited,
                                    std::span<const std::uint8_t> fresh = {}, const Job& job = {});

/// Per receiver 1, or 0 where it lies inside closed matter (a floor's texel under a cupboard): more
/// than a quarter of up to 64 cosine-weighted rays meet a side that receives nothing. ReceiverSet::
/// replaceInvalid() takes the answer. Errors: cancelled.
Result<std::vector<std::uint8_t>> findUncovered(const Surfaces& surfaces,
                                                const Receivers& receivers, const Job& job = {});

}  // namespace soffit::prt

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/light/receivers.h"
#include "core/transfer/texels.h"

namespace soffit::transfer {

/// The valid texels again, grouped for the direct stage (light::makeCompactReceivers): the order
/// that the bounce needs mixes far-off things of one orientation, which shadows pay for.
struct ShadowGroups {
  light::Receivers points;
  std::vector<std::uint32_t> place;  ///< per slot of the texels: the slot in `points` that it shows
};

/// fill_from: per slot, itself or the valid slot whose light it shows (Operators::fill_from).
ShadowGroups makeShadowGroups(const Texels& texels, std::span<const std::uint32_t> fill_from);

}  // namespace soffit::transfer

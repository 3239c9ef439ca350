// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/luminaire.h"

#include <span>

namespace soffit::light {

/// The colour temperature, kelvin, of the light of all luminaires together as they are dimmed
/// (color::correlatedTemperature() of the sum); 0 when none is on or none is coloured otherwise
/// than daylight. A luminaire without a flux of its own counts with its file's.
double whiteOf(std::span<const Luminaire> luminaires);

}  // namespace soffit::light

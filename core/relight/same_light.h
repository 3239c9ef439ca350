// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/emitter.h"

namespace soffit::relight {

/// Whether two emitters shed the same light up to gain and color: then what was computed for one
/// holds for the other, mixed anew.
bool sameLight(const light::Emitter& a, const light::Emitter& b);

}  // namespace soffit::relight

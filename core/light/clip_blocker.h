// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/light_mask.h"

namespace soffit::light {

/// The part of a convex blocker on the side n.x > d of a plane; count 0 when nothing is left.
MaskBlocker clipToFront(const MaskBlocker& blocker, const vec3& n, float d);

}  // namespace soffit::light

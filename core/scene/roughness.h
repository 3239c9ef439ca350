// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/material.h"

namespace soffit::scene {

/// What a material's roughness comes to over its whole roughness map.
struct RoughnessRange {
  double least = 0.5;
  double mean = 0.5;
};

/// roughness x map; both are material.roughness without a map. Large pictures are looked at in
/// 512 x 512 places at most: what a lobe reflects altogether hardly depends on its width.
RoughnessRange roughnessRange(const Material& material);

}  // namespace soffit::scene

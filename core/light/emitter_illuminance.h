// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/emitter.h"
#include "core/light/light_mask.h"
#include "core/math/vec.h"

namespace soffit::light {

/// Illuminance at p (scene-local, unit normal n) under an emitter that nothing hides, lux at
/// dimming 1, by the closed form of its shape. Lambertian shapes only, points excepted: they give
/// 0.
double closedForm(const Emitter& e, const dvec3& p, const dvec3& n);

/// The same as a sum over points of the emitter: sum I(w) cos / r^2.
double sampledIlluminance(const Emitter& e, const PointLightSamples& s, const dvec3& p,
                          const dvec3& n);

}  // namespace soffit::light

// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/operators.h"
#include "core/transfer/training.h"

#include <span>

namespace soffit::transfer {

/// Operators::conserve of operators whose texels and sends are complete.
///
/// gathered, interpolated  per field: what arrives of it, in lux times m^2, by all points' own rays and
/// by lists and weights.
float trustInConservation(const TrainingFields& fields, std::span<const double> gathered,
                          std::span<const double> interpolated, const Operators& operators);

}  // namespace soffit::transfer

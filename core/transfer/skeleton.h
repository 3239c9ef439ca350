// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/transfer/operators.h"
#include "core/transfer/training.h"

namespace soffit::transfer {

/// Chooses skeleton receivers and interpolation weights for every cluster and traces the
/// skeletons' gather lists: fills operators.lists, clusters, weights, list_area.
///
/// Per cluster: Y = the training fields gathered at all its texels; rows of Y are picked by
/// pivoted Gram-Schmidt (the texel that the ones so far explain worst), then
/// W = Y Ys^T (Ys Ys^T + lambda I)^-1 with lambda at the level of the ray noise, so that noise is
/// averaged rather than copied. Light-trained interpolative decomposition: design.md section 4.
/// Returns the number of rays traced.
std::uint64_t fillSkeletons(const StaticScene& scene, const TrainingFields& fields, const BakeSettings& settings,
                            const Job& job, Operators& operators);

}  // namespace soffit::transfer

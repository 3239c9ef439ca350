// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/transfer/operators.h"
#include "core/transfer/training.h"

namespace soffit::transfer {

/// Chooses skeleton receivers and interpolation weights for every cluster and traces the
/// skeletons' gather lists: fills operators.lists, clusters, weights, list_area.
///
/// Per cluster: Y = the training fields gathered at all its texels; C = Y Y^T + what light that
/// was not trained may do; skeleton points are picked by pivoted Cholesky of C (the texel that the
/// ones so far explain worst), then W = C_xs (C_ss + lambda I)^-1 with lambda at the level of the
/// ray noise, so that noise is averaged rather than copied. It is light-trained interpolative
/// decomposition (design.md section 4) and, seen from the points, kriging (Rasmussen & Williams
/// 2006, 2.25) with a covariance that is mostly measured.
/// Returns the number of rays traced.
std::uint64_t fillSkeletons(const StaticScene& scene, const TrainingFields& fields,
                            const BakeSettings& settings, const Job& job, Operators& operators);

}  // namespace soffit::transfer

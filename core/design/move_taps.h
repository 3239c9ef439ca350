// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/operators.h"

namespace soffit::design {

/// The work of one luminaire's move through these operators, counted instead of timed: the same on
/// every machine and at any load. In taps of a gather list: one for each entry of the lists and of
/// the nodes' lists, two thirds for each weight of the interpolation, 15 for each block of the node
/// matrix (all its products), 100 for each texel's direct light. These ratios are those of the
/// stages' times on the samples, rounded: a tap took 0.6 ns of two cores; a texel's direct light 55
/// to 125 ns with a panel, more with luminaires whose bodies shade one another. A sweep
/// (relight::Solver::sweeps()) takes lists and weights once more.
double moveTaps(const transfer::Operators& operators, int sweeps);

}  // namespace soffit::design

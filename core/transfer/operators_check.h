// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/operators.h"

#include <string>

namespace soffit::transfer {

/// Whether operators that come from outside can be used without reading past the end of an
/// array: sizes that belong together agree, every index lies within what it points into, every
/// number is finite. Says which part is wrong; empty when none is. Linear in the size.
std::string inconsistency(const Operators& operators);

}  // namespace soffit::transfer

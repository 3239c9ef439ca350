// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// The most memory that the process held at once.
namespace soffit::cli {

/// Starts anew from what is held now, where the system can (Linux); else nothing happens.
void resetPeakMemory();

/// Bytes since the last reset, or since the start; 0 where the system does not tell.
std::size_t peakMemory();

}  // namespace soffit::cli

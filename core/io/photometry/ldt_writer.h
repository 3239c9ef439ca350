// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/photometry/photometric_file.h"

namespace soffit::io {

/// EULUMDAT text with the strongest Isym that the table has exactly, one lamp set. The values are
/// cd per 1000 lm of the declared lamp flux; without one the photometry is absolute (-1 lamps) and
/// the flux is the table's own. Reads back with a relative error of a rounding or two.
std::string toLdt(const PhotometricFile& file);

/// Writes toLdt() whole or not at all.
Result<void> writeLdt(const std::filesystem::path& path, const PhotometricFile& file);

}  // namespace soffit::io

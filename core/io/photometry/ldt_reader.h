// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/photometry/photometric_file.h"

namespace soffit::io {

/// Reads a EULUMDAT (.ldt) file with any symmetry indicator.
///
/// Its values are cd per 1000 lm of the first lamp set's total flux; times its factor for luminous
/// intensities they are the candela here. A negative number of lamps marks absolute photometry:
/// the flux is then the luminaire's, and the values are scaled just the same. The lists of angles
/// count, not the distances Dc and Dg. Errors as for readIes().
Result<PhotometricFile> readLdt(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in errors.
Result<PhotometricFile> parseLdt(std::string_view text, const std::string& name);

}  // namespace soffit::io

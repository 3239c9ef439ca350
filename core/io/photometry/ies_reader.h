// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/photometry/photometric_file.h"

namespace soffit::io {

/// Reads an IES file of LM-63-1986, 1991, 1995, 2002 or 2019, photometry of type A, B or C.
///
/// Candela are multiplied by the multiplier, the ballast factor and, up to 1995, the ballast-lamp
/// factor. They are for all lamps already: lumens per lamp scale nothing. TILT factors hold for
/// tilted mounting only and are kept but not applied. Errors name file, line, what was expected
/// and what was found; a damaged file of any kind takes at most some 60 MB and well under 1 s.
Result<PhotometricFile> readIes(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in errors.
Result<PhotometricFile> parseIes(std::string_view text, const std::string& name,
                                 const TiltLoader& tilt = {});

}  // namespace soffit::io

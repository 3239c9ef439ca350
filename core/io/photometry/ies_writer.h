// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/photometry/photometric_file.h"

namespace soffit::io {

/// LM-63-2019 text, type C, metres, TILT=NONE. Numbers are written so that they read back to the
/// bit; planes that a mirror gives are left out. Lines stay within the 256 characters that LM-63
/// allows. Keywords are kept in order; LUMINAIRE is added from the name if it is missing.
std::string toIes(const PhotometricFile& file);

/// Writes toIes() whole or not at all.
Result<void> writeIes(const std::filesystem::path& path, const PhotometricFile& file);

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/io/photometry/number_stream.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace soffit::io {

/// Lamp output when the luminaire is mounted at a tilt, LM-63's TILT block. Some discharge lamps
/// give less light off the position they were measured in.
struct TiltTable {
  int lamp_geometry = 1;           ///< 1 lamp along the axis, 2 and 3 across it
  std::vector<double> angles_deg;  ///< ascending
  std::vector<double> factors;     ///< of the candela
};

/// Gives the text of a file that TILT= names.
using TiltLoader = std::function<Result<std::string>(const std::string& file)>;

/// Loads from `folder` only: an absolute path, "..", or a link that leads out is an error.
TiltLoader tiltLoader(const std::filesystem::path& folder);

/// Reads geometry, count, angles and factors.
Result<TiltTable> parseTilt(NumberStream& stream);

}  // namespace soffit::io

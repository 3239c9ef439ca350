// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/io/photometry/number_stream.h"
#include "core/io/photometry/photometric_file.h"

#include <string>
#include <vector>

/// Checks on the table that both formats share.
namespace soffit::io {

/// Angles per direction: a tenth of a degree all round and the closing one.
inline constexpr int kMaxAngles = 3601;
/// Values of one table as stored; twice the finest that goniometers deliver.
inline constexpr int kMaxEntries = 500000;

/// An error without a place if a table of these counts would be larger than kMaxEntries.
Result<void> checkEntries(int n_vertical, int n_horizontal);

/// Multiplies by the factor. Noise just below 0 becomes 0 with a warning; an error if a value is
/// clearly negative, if all are 0, or if one is beyond any lamp (1e12 cd). `start` is the stream
/// as it was before the first value; from it the error finds the line.
Result<void> scaleCandela(std::vector<double>& candela, double factor, const NumberStream& start,
                          std::vector<std::string>& warnings);

/// Warns if the luminaire gives clearly more light than its lamps are declared to.
void warnOfRatio(PhotometricFile& file);

}  // namespace soffit::io

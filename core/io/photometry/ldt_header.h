// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/io/photometry/photometric_file.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace soffit::io {

/// What EULUMDAT's lines say before the lists of angles; lengths in metres.
struct LdtHeader {
  int symmetry = 0;           ///< Isym 0..4
  int n_c = 0;                ///< Mc, planes of the whole circle
  double c_step_deg = 0;      ///< Dc, 0: not equidistant
  int n_gamma = 0;            ///< Ng
  double gamma_step_deg = 0;  ///< Dg, 0: not equidistant
  dvec3 opening{0.0};
  double factor = 1;       ///< conversion factor for luminous intensities
  double lamps = 1;        ///< of the first set; negative: absolute photometry
  double lamp_lumens = 0;  ///< total of the first set
  double watts = 0;
  std::vector<Keyword> keywords;
  std::vector<std::string> warnings;
  std::size_t data_offset = 0;  ///< where the list of C angles starts
};

/// Reads lines 1 to 26, the lamp sets and the ten direct ratios. A blank line is a field left
/// empty: text is empty then, a number 0; the counts and Isym may not be blank.
Result<LdtHeader> parseLdtHeader(std::string_view text, const std::string& name);

}  // namespace soffit::io

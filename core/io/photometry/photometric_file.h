// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/io/photometry/tilt.h"
#include "core/photometry/intensity_distribution.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Photometric files: IES LM-63 (1986 to 2019; types A, B, C) and EULUMDAT.
namespace soffit::io {

/// A labelled text of the file, UTF-8; the key is in capitals ("LUMCAT"), a free line of
/// LM-63-1986 has the key "LABEL". EULUMDAT's lines get the LM-63 key of the same meaning.
struct Keyword {
  std::string key;
  std::string value;
};

/// Everything that is read from one file.
struct PhotometricFile {
  photometry::IntensityDistribution distribution;  ///< candela with every factor applied
  std::string format;                              ///< "IES LM-63-2002", "EULUMDAT"
  int n_vertical = 0;     ///< vertical (gamma) angles as the file states them
  int n_horizontal = 0;   ///< horizontal (C) angles as the file states them
  std::string symmetry;   ///< as stored: "quadrant 0-90", "Isym 4, quadrant", ...
  double lumens = 0.0;    ///< integral of the stored table over the sphere
  bool absolute = false;  ///< absolute photometry: measured without reference to its lamps
  std::optional<double> lamp_lumens;  ///< declared flux of all lamps, if the file gives one
  double watts = 0.0;                 ///< input power as declared, 0 if unknown
  std::optional<TiltTable> tilt;      ///< of LM-63; kept, not applied
  std::vector<Keyword> keywords;
  std::vector<std::string> warnings;  ///< one sentence each: what is odd and how it was taken

  /// Light output ratio lumens / lamp_lumens; absent where the file gives no flux.
  [[nodiscard]] std::optional<double> lightOutputRatio() const;
  /// The value of the first keyword of that name (capitals), or nothing.
  [[nodiscard]] std::optional<std::string> keyword(std::string_view key) const;
};

/// Reads a file by what is in it, or if that does not tell, by its extension (.ies, .ldt).
/// Errors name the file and the line.
Result<PhotometricFile> readPhotometry(const std::filesystem::path& path);

/// The same from memory. `name` stands for the file in errors and gives the extension; `tilt`
/// loads a file that TILT= names (absent: such a name is an error).
Result<PhotometricFile> parsePhotometry(std::string_view text, const std::string& name,
                                        const TiltLoader& tilt = {});

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/photometry/photometric_file.h"
#include "core/photometry/beam.h"

namespace soffit::io {

/// What `soffit luminaire FILE` says of a file.
struct PhotometrySummary {
  std::string name;
  std::string format;    ///< "IES LM-63-2002", "EULUMDAT"
  double lumens = 0.0;   ///< integral over the sphere
  int n_vertical = 0;    ///< as the file states it
  int n_horizontal = 0;  ///< as the file states it
  std::string symmetry;  ///< as stored
  double peak_cd = 0.0;
  photometry::PrincipalAngles beam_deg;          ///< half of the plane's peak (CIE)
  photometry::PrincipalAngles field_deg;         ///< a tenth of the plane's peak (CIE)
  photometry::PrincipalAngles centre_beam_deg;   ///< half of the intensity on the axis (IES)
  photometry::PrincipalAngles centre_field_deg;  ///< a tenth of the intensity on the axis (IES)
  bool absolute = false;
  std::optional<double> lamp_lumens;
  std::optional<double> light_output_ratio;
  double watts = 0.0;
  std::optional<double> efficacy;  ///< lm/W, if the watts are known
  dvec3 opening{0.0};              ///< metres along x, y, z; negative: round
  std::vector<std::string> warnings;
};

PhotometrySummary summarize(const PhotometricFile& file);

/// The same as lines of text for people, with a line end after each.
std::string toText(const PhotometrySummary& summary);

}  // namespace soffit::io

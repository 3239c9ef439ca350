// SPDX-License-Identifier: MIT
#include "core/io/photometry/summary.h"

#include <fmt/format.h>

namespace soffit::io {
namespace {

using photometry::BeamReference;

std::string openingText(const dvec3& opening) {
  if (opening == dvec3(0.0)) return "a point";
  const char* shape = opening.x < 0.0 || opening.y < 0.0 ? "round" : "rectangular";
  const dvec3 size = glm::abs(opening);
  return fmt::format("{:.3g} x {:.3g} x {:.3g} m, {}", size.x, size.y, size.z, shape);
}

std::string anglesText(const photometry::PrincipalAngles& peak,
                       const photometry::PrincipalAngles& centre) {
  return fmt::format(
      "{:.1f} deg in C0-C180, {:.1f} deg in C90-C270 (of the axis: {:.1f}, {:.1f} deg)",
      peak.c0_deg, peak.c90_deg, centre.c0_deg, centre.c90_deg);
}

}  // namespace

PhotometrySummary summarize(const PhotometricFile& file) {
  const photometry::IntensityDistribution& d = file.distribution;
  PhotometrySummary s;
  s.name = d.name;
  s.format = file.format;
  s.lumens = file.lumens;
  s.n_vertical = file.n_vertical;
  s.n_horizontal = file.n_horizontal;
  s.symmetry = file.symmetry;
  s.peak_cd = d.peak();
  s.beam_deg = photometry::beamAngles(d, BeamReference::peak);
  s.field_deg = photometry::fieldAngles(d, BeamReference::peak);
  s.centre_beam_deg = photometry::beamAngles(d, BeamReference::centre);
  s.centre_field_deg = photometry::fieldAngles(d, BeamReference::centre);
  s.absolute = file.absolute;
  s.lamp_lumens = file.lamp_lumens;
  s.light_output_ratio = file.lightOutputRatio();
  s.watts = file.watts;
  if (file.watts > 0.0) s.efficacy = file.lumens / file.watts;
  s.opening = d.opening;
  s.warnings = file.warnings;
  return s;
}

std::string toText(const PhotometrySummary& s) {
  std::string out;
  const auto line = [&](const char* label, const std::string& value) {
    out += fmt::format("{:<12} {}\n", label, value);
  };
  if (!s.name.empty()) line("name", s.name);
  line("format", s.format);
  line("lumens", fmt::format("{:.8g}", s.lumens));
  line("angles", fmt::format("{} vertical x {} horizontal", s.n_vertical, s.n_horizontal));
  line("symmetry", s.symmetry);
  line("peak", fmt::format("{:.6g} cd", s.peak_cd));
  line("beam angle", anglesText(s.beam_deg, s.centre_beam_deg));
  line("field angle", anglesText(s.field_deg, s.centre_field_deg));
  line("photometry", s.absolute ? "absolute" : "relative");
  if (s.lamp_lumens) line("lamps", fmt::format("{:.6g} lm", *s.lamp_lumens));
  if (s.light_output_ratio) {
    line("LOR", fmt::format("{:.4g} %", 100.0 * *s.light_output_ratio));
  }
  if (s.efficacy) line("power", fmt::format("{:.4g} W, {:.4g} lm/W", s.watts, *s.efficacy));
  line("opening", openingText(s.opening));
  for (const std::string& warning : s.warnings) line("warning", warning);
  return out;
}

}  // namespace soffit::io

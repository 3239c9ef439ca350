// SPDX-License-Identifier: MIT
#include "core/io/photometry/ldt_reader.h"

#include "core/io/photometry/candela.h"
#include "core/io/photometry/ldt_header.h"
#include "core/io/photometry/text.h"
#include "core/io/photometry/text_file.h"
#include "core/photometry/planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace soffit::io {
namespace {

using photometry::Mirror;

constexpr double kAngleDeg = 1e-3;

/// The stored planes among the listed ones, in the order of the file.
struct Selection {
  std::vector<double> c_deg;  ///< ascending; Isym 3 goes on beyond 360
  Mirror mirror = Mirror::none;
};

Error wrongPlanes(const char* expected, double first, double last, int symmetry) {
  return {"",
          fmt::format("expected C-planes {} for Isym {}, found {:g}..{:g}", expected, symmetry,
                      first, last),
          "The list of C angles or Isym is damaged."};
}

bool is(double angle, double wanted) {
  return std::abs(angle - wanted) < kAngleDeg;
}

Result<Selection> wholeCircle(const std::vector<double>& c) {
  double widest = 0.0;
  for (std::size_t i = 0; i + 1 < c.size(); ++i) widest = std::max(widest, c[i + 1] - c[i]);
  const double closing = c.front() + 360.0 - c.back();
  if (c.size() > 1 && (c.front() < -kAngleDeg || closing < -kAngleDeg || closing > 1.5 * widest)) {
    return wrongPlanes("all round", c.front(), c.back(), 0);
  }
  return Selection{c, Mirror::none};
}

/// Planes from 0 to `last`.
Result<Selection> startingAtZero(const std::vector<double>& c, std::size_t count, double last,
                                 Mirror mirror, int symmetry) {
  if (count > c.size() || !is(c[0], 0.0) || !is(c[count - 1], last)) {
    return wrongPlanes(last == 90.0 ? "0..90" : "0..180", c[0], c[std::min(count, c.size()) - 1],
                       symmetry);
  }
  return Selection{{c.begin(), c.begin() + static_cast<std::ptrdiff_t>(count)}, mirror};
}

/// Isym 3: the file starts at C270 and goes through C0 to C90.
Result<Selection> fromC270(const std::vector<double>& c) {
  const auto start = std::find_if(c.begin(), c.end(), [](double a) { return is(a, 270.0); });
  Selection s{{start, c.end()}, Mirror::c90};
  if (!s.c_deg.empty() && is(s.c_deg.back(), 360.0)) s.c_deg.pop_back();  // it is C0 again
  for (const double a : c) {
    if (a < 90.0 + kAngleDeg) s.c_deg.push_back(a + 360.0);
  }
  if (start == c.end() || !is(s.c_deg.back(), 450.0)) {
    return wrongPlanes("with 270, 0 and 90", c.front(), c.back(), 3);
  }
  return s;
}

Result<Selection> select(const std::vector<double>& c, int symmetry) {
  switch (symmetry) {
    case 1:
      return Selection{{0.0}, Mirror::none};
    case 2:
      return startingAtZero(c, c.size() / 2 + 1, 180.0, Mirror::c0, 2);
    case 3:
      return fromC270(c);
    case 4:
      return startingAtZero(c, c.size() / 4 + 1, 90.0, Mirror::both, 4);
    default:
      return wholeCircle(c);
  }
}

void warnOfStep(const std::vector<double>& angles, double step, const char* which,
                std::vector<std::string>& warnings) {
  if (step == 0.0 || angles.size() < 2) return;
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
    if (is(angles[i + 1] - angles[i], step)) continue;
    warnings.push_back(
        fmt::format("the {} are not {:g} degrees apart as stated; the list is used", which, step));
    return;
  }
}

/// cd per value: the flux in thousands of lumens times the factor.
Result<double> candelaFactor(LdtHeader& h, const std::string& name) {
  double kilolumens = h.lamp_lumens / 1000.0;
  if (h.lamp_lumens == 0.0 && h.lamps < 0.0) {
    kilolumens = 1.0;
    h.warnings.emplace_back("absolute photometry without a flux; the values are taken as candela");
  }
  const double factor = kilolumens * h.factor;
  if (factor > 0.0 && std::isfinite(factor)) return factor;
  return Error{name,
               fmt::format("expected a lamp flux and a factor above 0, found {:g} lm x {:g}",
                           h.lamp_lumens, h.factor),
               "The values are cd per 1000 lm of the lamps: give their total flux."};
}

Result<photometry::StoredPlanes> readPlanes(NumberStream& in, LdtHeader& h, double factor,
                                            Mirror& mirror) {
  photometry::StoredPlanes planes;
  const auto n_c = static_cast<std::size_t>(h.n_c);
  const auto n_gamma = static_cast<std::size_t>(h.n_gamma);
  // With axial symmetry the C angles mean nothing, and some programs write zeros.
  const auto c = h.symmetry == 1 ? in.numbers(n_c, "C angles") : in.ascending(n_c, "C angles");
  if (!c) return c.error();
  auto selection = select(*c, h.symmetry);
  if (!selection) return in.error(selection.error().what, selection.error().hint);
  auto gamma = in.ascending(n_gamma, "gamma angles");
  if (!gamma) return gamma.error();
  if (gamma->front() < -kAngleDeg || gamma->back() > 180.0 + kAngleDeg) {
    return in.error(fmt::format("expected gamma angles within 0..180, found {:g}..{:g}",
                                gamma->front(), gamma->back()),
                    "The list of gamma angles is damaged.");
  }
  const auto stored = static_cast<int>(selection->c_deg.size());
  if (auto r = checkEntries(h.n_gamma, stored); !r) {
    return in.error(r.error().what, r.error().hint);
  }
  const NumberStream start = in;
  auto cd = in.numbers(
      selection->c_deg.size() * n_gamma,
      fmt::format("candela values ({} gamma angles x {} stored C-planes)", h.n_gamma, stored));
  if (!cd) return cd.error();
  if (auto r = scaleCandela(*cd, factor, start, h.warnings); !r) return r.error();
  if (h.symmetry != 1) warnOfStep(*c, h.c_step_deg, "C-planes", h.warnings);
  warnOfStep(*gamma, h.gamma_step_deg, "gamma angles", h.warnings);
  for (double& g : *gamma) g = std::clamp(g, 0.0, 180.0);
  mirror = selection->mirror;
  return photometry::StoredPlanes{std::move(selection->c_deg), std::move(*gamma), std::move(*cd)};
}

const char* symmetryText(int symmetry) {
  constexpr std::array kTexts{"Isym 0, none", "Isym 1, axial", "Isym 2, bilateral about C0-C180",
                              "Isym 3, bilateral about C90-C270", "Isym 4, quadrant"};
  return kTexts.at(static_cast<std::size_t>(symmetry));
}

}  // namespace

Result<PhotometricFile> parseLdt(std::string_view raw, const std::string& name) {
  if (auto r = checkReadable(raw, name, "a EULUMDAT file"); !r) return r.error();
  const std::string_view text = withoutBom(raw);
  auto header = parseLdtHeader(text, name);
  if (!header) return header.error();
  const auto factor = candelaFactor(*header, name);
  if (!factor) return factor.error();
  NumberStream in(text, header->data_offset, name, Comma::decimal);
  Mirror mirror = Mirror::none;
  const auto planes = readPlanes(in, *header, *factor, mirror);
  if (!planes) return planes.error();

  PhotometricFile file;
  file.distribution = photometry::unfold(*planes, mirror);
  file.distribution.opening = header->opening;
  file.format = "EULUMDAT";
  file.n_vertical = header->n_gamma;
  file.n_horizontal = header->n_c;
  file.symmetry = symmetryText(header->symmetry);
  file.lumens = file.distribution.flux();
  file.absolute = header->lamps < 0.0;
  if (header->lamp_lumens > 0.0) file.lamp_lumens = header->lamp_lumens;
  file.watts = header->watts;
  file.keywords = std::move(header->keywords);
  file.warnings = std::move(header->warnings);
  file.distribution.name = file.keyword("LUMINAIRE").value_or("");
  if (const std::size_t more = in.remaining(); more > 0) {
    file.warnings.push_back(fmt::format("{} numbers follow the candela values; ignored", more));
  }
  warnOfRatio(file);
  return file;
}

Result<PhotometricFile> readLdt(const std::filesystem::path& path) {
  const auto text = loadText(path);
  if (!text) return text.error();
  return parseLdt(*text, path.string());
}

}  // namespace soffit::io

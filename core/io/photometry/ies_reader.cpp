// SPDX-License-Identifier: MIT
#include "core/io/photometry/ies_reader.h"

#include "core/io/photometry/candela.h"
#include "core/io/photometry/ies_heading.h"
#include "core/io/photometry/ies_planes.h"
#include "core/io/photometry/text.h"
#include "core/io/photometry/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::io {
namespace {

constexpr double kMetresPerFoot = 0.3048;

/// The thirteen numbers between TILT and the angles, in the file's units.
struct IesNumbers {
  double lamps = 1;
  double lumens_per_lamp = -1;
  double multiplier = 1;
  int n_vertical = 0;
  int n_horizontal = 0;
  IesType type = IesType::c;
  int units = 2;
  dvec3 opening{0.0};  ///< width, length, height
  double ballast_factor = 1;
  double second_factor = 1;  ///< ballast-lamp factor, reserved, or file generation type, by edition
  double watts = 0;
};

Result<IesNumbers> readNumbers(NumberStream& in) {
  IesNumbers n;
  Error failed;
  const auto real = [&](double& to, const char* what) {
    auto r = in.number(what);
    if (r) to = *r;
    if (!r) failed = r.error();
    return r.ok();
  };
  const auto whole = [&](int& to, const char* what, int min, int max) {
    auto r = in.whole(what, min, max);
    if (r) to = *r;
    if (!r) failed = r.error();
    return r.ok();
  };
  int type = 1;
  const bool ok =
      real(n.lamps, "the number of lamps") && real(n.lumens_per_lamp, "the lumens per lamp") &&
      real(n.multiplier, "the candela multiplier") &&
      whole(n.n_vertical, "the number of vertical angles", 2, kMaxAngles) &&
      whole(n.n_horizontal, "the number of horizontal angles", 1, kMaxAngles) &&
      whole(type, "the photometric type", 1, 3) && whole(n.units, "the units", 1, 2) &&
      real(n.opening.x, "the luminous width") && real(n.opening.y, "the luminous length") &&
      real(n.opening.z, "the luminous height") && real(n.ballast_factor, "the ballast factor") &&
      real(n.second_factor, "the ballast-lamp factor") && real(n.watts, "the input watts");
  if (!ok) return failed;
  n.type = static_cast<IesType>(type);
  return n;
}

/// What every candela value is multiplied by; the second factor's meaning changed with the edition.
Result<double> candelaFactor(const IesNumbers& n, int year, NumberStream& in,
                             std::vector<std::string>& warnings) {
  double factor = n.multiplier * n.ballast_factor;
  if (year <= 1995) factor *= n.second_factor;
  if (year == 2002 && n.second_factor != 1.0) {
    warnings.push_back(fmt::format(
        "the field after the ballast factor is {:g}; LM-63-2002 reserves it as 1, so it is ignored",
        n.second_factor));
  }
  if (factor > 0.0 && std::isfinite(factor)) return factor;
  return in.error(fmt::format("expected a multiplier and ballast factors above 0, found {:g} x "
                              "{:g}{}",
                              n.multiplier, n.ballast_factor,
                              year <= 1995 ? fmt::format(" x {:g}", n.second_factor) : ""),
                  "Set the factors to 1 if they are unknown.");
}

/// Metres; -d 0 is a circle of diameter d in the editions before 2002.
dvec3 openingOf(const IesNumbers& n) {
  dvec3 opening = n.opening * (n.units == 1 ? kMetresPerFoot : 1.0);
  if (opening.x < 0.0 && opening.y == 0.0) opening.y = opening.x;
  return opening;
}

Result<IesTable> readTable(NumberStream& in, const IesNumbers& n, double factor,
                           std::vector<std::string>& warnings) {
  const auto vertical = static_cast<std::size_t>(n.n_vertical);
  const auto horizontal = static_cast<std::size_t>(n.n_horizontal);
  if (auto r = checkEntries(n.n_vertical, n.n_horizontal); !r) {
    return in.error(r.error().what, r.error().hint);
  }
  IesTable table;
  table.type = n.type;
  auto v = in.ascending(vertical, "vertical angles");
  if (!v) return v.error();
  auto h = in.ascending(horizontal, "horizontal angles");
  if (!h) return h.error();
  if (auto r = checkIesAngles(n.type, *v, *h); !r) return in.error(r.error().what, r.error().hint);
  const NumberStream start = in;
  auto cd = in.numbers(vertical * horizontal,
                       fmt::format("candela values ({} vertical x {} horizontal angles)",
                                   n.n_vertical, n.n_horizontal));
  if (!cd) return cd.error();
  if (auto r = scaleCandela(*cd, factor, start, warnings); !r) return r.error();
  table.vertical_deg = std::move(*v);
  table.horizontal_deg = std::move(*h);
  table.candela = std::move(*cd);
  return table;
}

Result<TiltTable> readTilt(const IesHeading& heading, const std::string& name, NumberStream& in,
                           const TiltLoader& loader) {
  if (heading.tilt == "INCLUDE") return parseTilt(in);
  const Error here = in.error("", "");
  if (heading.tilt.empty() || !loader) {
    return Error{here.place, "expected TILT=NONE or TILT=INCLUDE, found " + shown(heading.tilt),
                 "Write TILT=NONE if the lamp may burn in any position."};
  }
  const auto text = loader(heading.tilt);
  if (!text) return Error{name, text.error().what, text.error().hint};
  NumberStream numbers(*text, 0, heading.tilt);
  return parseTilt(numbers);
}

void nameFrom(PhotometricFile& file) {
  for (const char* key : {"LUMINAIRE", "LUMCAT", "LABEL"}) {
    if (!file.distribution.name.empty()) return;
    file.distribution.name = file.keyword(key).value_or("");
  }
}

void warnOfOddities(const IesNumbers& n, NumberStream& in, PhotometricFile& file) {
  if (const std::size_t more = in.remaining(); more > 0) {
    file.warnings.push_back(fmt::format("{} numbers follow the candela values; ignored", more));
  }
  if (file.tilt) file.warnings.emplace_back("TILT factors are for tilted mounting; not applied");
  if (n.lumens_per_lamp < 0.0 && n.lumens_per_lamp != -1.0) {
    file.warnings.push_back(fmt::format(
        "lumens per lamp are {:g}; taken as -1, absolute photometry", n.lumens_per_lamp));
  }
  if (n.watts < 0.0) file.warnings.emplace_back("the input watts are negative; taken as unknown");
  warnOfRatio(file);
}

}  // namespace

Result<PhotometricFile> parseIes(std::string_view raw, const std::string& name,
                                 const TiltLoader& loader) {
  if (auto r = checkReadable(raw, name, "an IES file"); !r) return r.error();
  const std::string_view text = withoutBom(raw);
  auto heading = parseIesHeading(text, name);
  if (!heading) return heading.error();
  NumberStream in(text, heading->data_offset, name);
  PhotometricFile file;
  file.warnings = std::move(heading->warnings);
  if (heading->tilt != "NONE") {
    auto tilt = readTilt(*heading, name, in, loader);
    if (!tilt) return tilt.error();
    file.tilt = std::move(*tilt);
  }
  const auto numbers = readNumbers(in);
  if (!numbers) return numbers.error();
  const auto factor = candelaFactor(*numbers, heading->year, in, file.warnings);
  if (!factor) return factor.error();
  auto table = readTable(in, *numbers, *factor, file.warnings);
  if (!table) return table.error();
  IesSphere sphere = toSphere(std::move(*table));

  file.distribution = std::move(sphere.distribution);
  file.distribution.opening = openingOf(*numbers);
  file.format = fmt::format("IES LM-63-{}", heading->year);
  file.n_vertical = numbers->n_vertical;
  file.n_horizontal = numbers->n_horizontal;
  file.symmetry = std::move(sphere.symmetry);
  file.lumens = sphere.lumens;
  file.absolute = numbers->lumens_per_lamp < 0.0;
  if (numbers->lumens_per_lamp > 0.0 && numbers->lamps > 0.0) {
    file.lamp_lumens = numbers->lumens_per_lamp * numbers->lamps;
  }
  file.watts = std::max(numbers->watts, 0.0);
  file.keywords = std::move(heading->keywords);
  file.warnings.insert(file.warnings.end(), sphere.warnings.begin(), sphere.warnings.end());
  nameFrom(file);
  warnOfOddities(*numbers, in, file);
  return file;
}

Result<PhotometricFile> readIes(const std::filesystem::path& path) {
  const auto text = loadText(path);
  if (!text) return text.error();
  return parseIes(*text, path.string(), tiltLoader(path.parent_path()));
}

}  // namespace soffit::io

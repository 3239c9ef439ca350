// SPDX-License-Identifier: MIT
#include "core/io/photometry/ldt_writer.h"

#include "core/io/photometry/text.h"
#include "core/io/photometry/text_file.h"
#include "core/photometry/planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace soffit::io {
namespace {

using photometry::IntensityDistribution;
using photometry::Mirror;

constexpr double kMillimetresPerMetre = 1e3;

/// Lines of the file, one field each.
class Lines {
 public:
  void text(const std::string& value) { out_ += toUtf8(value) + "\r\n"; }
  void text(const PhotometricFile& file, const char* key) { text(file.keyword(key).value_or("")); }
  void number(double value) { fmt::format_to(std::back_inserter(out_), "{}\r\n", value); }
  void numbers(const std::vector<double>& values) {
    for (const double value : values) number(value);
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

/// The common step of equidistant angles, else 0 as the format wants it.
double commonStep(const std::vector<double>& angles) {
  if (angles.size() < 2) return 0.0;
  const double step = angles[1] - angles[0];
  for (std::size_t i = 1; i + 1 < angles.size(); ++i) {
    if (std::abs(angles[i + 1] - angles[i] - step) > 1e-9) return 0.0;
  }
  return step;
}

/// Share of the flux below the horizon.
double downwardShare(const IntensityDistribution& d) {
  IntensityDistribution below = d;
  below.gamma_deg.clear();
  below.candela.clear();
  for (const double gamma : d.gamma_deg) {
    if (gamma < 90.0) below.gamma_deg.push_back(gamma);
  }
  if (below.gamma_deg.empty()) return 0.0;
  below.gamma_deg.push_back(std::min(90.0, d.gamma_deg.back()));
  if (below.gamma_deg.size() > d.gamma_deg.size()) return 1.0;
  for (const double c : d.c_deg) {
    for (const double gamma : below.gamma_deg) below.candela.push_back(d.intensityAt(c, gamma));
  }
  return below.flux() / d.flux();
}

int isymOf(Mirror mirror, std::size_t planes) {
  switch (mirror) {
    case Mirror::c0:
      return 2;
    case Mirror::c90:
      return 3;
    case Mirror::both:
      return 4;
    case Mirror::none:
      break;
  }
  return planes == 1 ? 1 : 0;
}

/// Isym 3 starts at C270 and goes through C0 to C90, the mirror image of what fold() keeps.
photometry::StoredPlanes inFileOrder(photometry::StoredPlanes planes, Mirror mirror) {
  if (mirror != Mirror::c90) return planes;
  const std::size_t columns = planes.gamma_deg.size();
  std::vector<double> reversed;
  reversed.reserve(planes.candela.size());
  for (std::size_t row = planes.c_deg.size(); row-- > 0;) {
    const auto start = planes.candela.begin() + static_cast<std::ptrdiff_t>(row * columns);
    reversed.insert(reversed.end(), start, start + static_cast<std::ptrdiff_t>(columns));
  }
  planes.candela = std::move(reversed);
  return planes;
}

void writeOpening(Lines& out, const dvec3& opening) {
  const bool is_round = opening.x < 0.0;
  const double length = std::abs(opening.y) * kMillimetresPerMetre;
  const double width = is_round ? 0.0 : opening.x * kMillimetresPerMetre;
  const double height = std::abs(opening.z) * kMillimetresPerMetre;
  out.numbers({length, width, height});  // the housing: nothing better is known
  out.numbers({length, width});
  out.numbers({height, height, height, height});
}

}  // namespace

std::string toLdt(const PhotometricFile& file) {
  const IntensityDistribution& d = file.distribution;
  auto [folded, mirror] = photometry::fold(d);
  const photometry::StoredPlanes planes = inFileOrder(std::move(folded), mirror);
  const double lumens = d.flux();
  const bool absolute = file.absolute || !file.lamp_lumens;
  const double lamp_lumens = file.lamp_lumens.value_or(lumens);
  Lines out;
  out.text(file, "MANUFAC");
  out.number(d.c_deg.size() == 1 ? 1 : 3);
  out.number(isymOf(mirror, d.c_deg.size()));
  out.number(static_cast<double>(d.c_deg.size()));
  out.number(commonStep(d.c_deg));
  out.number(static_cast<double>(d.gamma_deg.size()));
  out.number(commonStep(d.gamma_deg));
  out.text(file, "TEST");
  out.text(d.name);
  out.text(file, "LUMCAT");
  out.text(file, "FILENAME");
  out.text(file, "ISSUEDATE");
  writeOpening(out, d.opening);
  out.number(100.0 * downwardShare(d));
  out.number(absolute ? 100.0 : 100.0 * lumens / lamp_lumens);
  out.numbers({1.0, 0.0, 1.0});  // factor, tilt, lamp sets
  out.number(absolute ? -1 : 1);
  out.text(file, "LAMP");
  out.number(lamp_lumens);
  out.text(file, "COLORTEMP");
  out.text(file, "CRI");
  out.number(file.watts);
  out.numbers(std::vector<double>(10, 0.0));  // direct ratios: not known
  out.numbers(d.c_deg);
  out.numbers(d.gamma_deg);
  std::vector<double> values = planes.candela;
  for (double& value : values) value *= 1000.0 / lamp_lumens;
  out.numbers(values);
  return out.take();
}

Result<void> writeLdt(const std::filesystem::path& path, const PhotometricFile& file) {
  return saveText(path, toLdt(file));
}

}  // namespace soffit::io

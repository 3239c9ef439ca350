// SPDX-License-Identifier: MIT
#include "core/io/photometry/ies_writer.h"

#include "core/io/photometry/text.h"
#include "core/io/photometry/text_file.h"
#include "core/photometry/planes.h"

#include <fmt/format.h>

#include <iterator>
#include <span>

namespace soffit::io {
namespace {

constexpr std::size_t kLineLength = 120;
// File generation type of LM-63-2019 for "not stated".
constexpr const char* kGenerationUnstated = "1.00001";

void appendNumbers(std::string& out, std::span<const double> numbers) {
  std::size_t line_start = out.size();
  for (const double number : numbers) {
    if (out.size() - line_start > kLineLength) {
      out.back() = '\n';
      line_start = out.size();
    }
    fmt::format_to(std::back_inserter(out), "{} ", number);
  }
  out.back() = '\n';
}

void appendKeyword(std::string& out, const Keyword& keyword) {
  std::string rest = toUtf8(keyword.value);
  std::string key = keyword.key;
  do {
    fmt::format_to(std::back_inserter(out), "[{}] {}\n", key, rest.substr(0, kLineLength));
    rest.erase(0, kLineLength);
    key = "MORE";
  } while (!rest.empty());
}

}  // namespace

std::string toIes(const PhotometricFile& file) {
  const photometry::IntensityDistribution& d = file.distribution;
  auto [planes, mirror] = photometry::fold(d);
  if (mirror == photometry::Mirror::none && planes.c_deg.size() > 1) {
    planes.c_deg.push_back(360.0);
    for (std::size_t g = 0; g < d.gamma_deg.size(); ++g) planes.candela.push_back(d.candela[g]);
  }
  std::string out = "IES:LM-63-2019\n";
  for (const Keyword& keyword : file.keywords) appendKeyword(out, keyword);
  if (!file.keyword("LUMINAIRE")) appendKeyword(out, {"LUMINAIRE", d.name});
  out += "TILT=NONE\n";
  const bool relative = file.lamp_lumens && !file.absolute;
  fmt::format_to(std::back_inserter(out), "1 {} 1 {} {} 1 2 {} {} {}\n1 {} {}\n",
                 relative ? *file.lamp_lumens : -1.0, planes.gamma_deg.size(), planes.c_deg.size(),
                 d.opening.x, d.opening.y, d.opening.z, kGenerationUnstated, file.watts);
  appendNumbers(out, planes.gamma_deg);
  appendNumbers(out, planes.c_deg);
  const std::span<const double> candela = planes.candela;
  const std::size_t columns = planes.gamma_deg.size();
  for (std::size_t c = 0; c < planes.c_deg.size(); ++c) {
    appendNumbers(out, candela.subspan(c * columns, columns));
  }
  return out;
}

Result<void> writeIes(const std::filesystem::path& path, const PhotometricFile& file) {
  return saveText(path, toIes(file));
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/io/photometry/ldt_header.h"

#include "core/io/photometry/candela.h"
#include "core/io/photometry/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace soffit::io {
namespace {

constexpr int kMaxLampSets = 20;
constexpr double kMetresPerMillimetre = 1e-3;

/// Fields line by line; after a failure everything is 0 and `failed` keeps the first one.
class Fields {
 public:
  Fields(std::string_view text, std::string name) : lines_(text), name_(std::move(name)) {}

  std::string text(const char* what) { return toUtf8(trimmed(line(what))); }

  double number(const char* what) {
    const std::string_view found = trimmed(line(what));
    if (found.empty() || failed_) return 0.0;
    std::string dotted(found);
    if (const auto comma = dotted.find(','); comma != dotted.npos) dotted[comma] = '.';
    const auto value = parseNumber(dotted);
    if (value && std::isfinite(*value)) return *value;
    fail(fmt::format("expected {}, found {}", what, shown(found)));
    return 0.0;
  }

  int whole(const char* what, int min, int max) {
    const double value = number(what);
    if (failed_) return min;
    if (value == std::floor(value) && value >= min && value <= max) return static_cast<int>(value);
    fail(fmt::format("expected {} ({} to {}), found {:g}", what, min, max, value));
    return min;
  }

  [[nodiscard]] const std::optional<Error>& failed() const { return failed_; }
  [[nodiscard]] std::size_t offset() const { return lines_.offset(); }

 private:
  std::string_view line(const char* what) {
    if (failed_) return {};
    if (lines_.atEnd()) {
      fail(fmt::format("expected {}, found the end of the file", what));
      return {};
    }
    return lines_.next();
  }

  void fail(std::string what) {
    failed_ = Error{placeAt(name_, std::max(lines_.line(), 1)), std::move(what),
                    "The file is damaged or no EULUMDAT file: it has one field per line. Download "
                    "it again."};
  }

  LineCursor lines_;
  std::string name_;
  std::optional<Error> failed_;
};

/// Lines 13 to 21. The luminous area counts, not the housing; its length lies along C90-C270, a
/// width of 0 makes it round.
dvec3 readOpening(Fields& in) {
  in.number("the luminaire's length");
  in.number("the luminaire's width");
  in.number("the luminaire's height");
  const double length = in.number("the luminous area's length");
  const double width = in.number("the luminous area's width");
  double height = 0.0;
  for (const char* plane : {"the luminous height at C0", "the luminous height at C90",
                            "the luminous height at C180", "the luminous height at C270"}) {
    height = std::max(height, in.number(plane));
  }
  const bool is_round = width == 0.0 && length > 0.0;
  const dvec3 opening{is_round ? -length : width, is_round ? -length : length, height};
  return opening * kMetresPerMillimetre;
}

/// Line 26 and the lamp sets. Sets are alternatives; the first is the one that is shown.
void readLampSets(Fields& in, LdtHeader& h) {
  const int sets = in.whole("the number of lamp sets", 1, kMaxLampSets);
  for (int i = 0; i < sets; ++i) {
    const double lamps = in.number("the number of lamps");
    const std::string type = in.text("the type of lamps");
    const double lumens = in.number("the total luminous flux of the lamps");
    const std::string color = in.text("the colour of the lamps");
    const std::string rendering = in.text("the colour rendering of the lamps");
    const double watts = in.number("the watts including the ballast");
    if (i > 0) continue;
    h.lamps = lamps;
    h.lamp_lumens = lumens;
    h.watts = watts;
    h.keywords.push_back({"LAMP", type});
    h.keywords.push_back({"COLORTEMP", color});
    h.keywords.push_back({"CRI", rendering});
  }
  if (sets > 1) {
    h.warnings.push_back(fmt::format("{} lamp sets are given; the first is used", sets));
  }
}

void checkNumbers(LdtHeader& h) {
  if (h.factor == 0.0) {
    h.factor = 1.0;
    h.warnings.emplace_back("the factor for luminous intensities is 0; taken as 1");
  }
  if (h.watts < 0.0) {
    h.watts = 0.0;
    h.warnings.emplace_back("the watts are negative; taken as unknown");
  }
  if (std::min({h.opening.x, h.opening.y, h.opening.z}) < 0.0 && h.opening.x != h.opening.y) {
    h.opening = glm::abs(h.opening);
    h.warnings.emplace_back("the luminous area has negative sides; their sign is dropped");
  }
}

}  // namespace

Result<LdtHeader> parseLdtHeader(std::string_view text, const std::string& name) {
  Fields in(text, name);
  LdtHeader h;
  h.keywords.push_back({"MANUFAC", in.text("the company")});
  in.text("the type indicator");
  h.symmetry = in.whole("the symmetry indicator Isym", 0, 4);
  h.n_c = in.whole("the number of C-planes Mc", 1, kMaxAngles);
  h.c_step_deg = in.number("the distance of C-planes Dc");
  h.n_gamma = in.whole("the number of gamma angles Ng", 2, kMaxAngles);
  h.gamma_step_deg = in.number("the distance of gamma angles Dg");
  constexpr std::array kLabels{"TEST", "LUMINAIRE", "LUMCAT", "FILENAME", "ISSUEDATE"};
  for (const char* label : kLabels) h.keywords.push_back({label, in.text("a name")});
  h.opening = readOpening(in);
  in.number("the downward flux fraction");
  in.number("the light output ratio");
  h.factor = in.number("the factor for luminous intensities");
  in.number("the tilt of the luminaire");
  readLampSets(in, h);
  for (int i = 0; i < 10; ++i) in.number("a direct ratio");
  if (in.failed()) return *in.failed();
  checkNumbers(h);
  h.data_offset = in.offset();
  return h;
}

}  // namespace soffit::io

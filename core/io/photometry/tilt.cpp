// SPDX-License-Identifier: MIT
#include "core/io/photometry/tilt.h"

#include "core/io/photometry/text.h"
#include "core/io/photometry/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace soffit::io {
namespace fs = std::filesystem;
namespace {

constexpr int kMaxTiltAngles = 1000;

Error leavesFolder(const std::string& file) {
  return {"", fmt::format("expected a TILT file beside the IES file, found {}", shown(file)),
          "A TILT file may not lie outside the folder: copy it there and name it alone."};
}

bool staysInside(const fs::path& file) {
  if (file.empty() || file.is_absolute() || file.has_root_path()) return false;
  // A DOS drive letter is a plain name here, but it was meant to lead elsewhere.
  if (file.string().find(':') != std::string::npos) return false;
  return std::none_of(file.begin(), file.end(), [](const fs::path& part) { return part == ".."; });
}

}  // namespace

TiltLoader tiltLoader(const fs::path& folder) {
  return [folder](const std::string& named) -> Result<std::string> {
    std::string file = named;
    std::replace(file.begin(), file.end(), '\\', '/');
    if (!staysInside(file)) return leavesFolder(named);
    std::error_code code;
    const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, code);
    const fs::path target = fs::canonical(root / file, code);
    if (code) {
      return Error{"", fmt::format("expected the TILT file {}, found none", shown(named)),
                   "Put it beside the IES file, or write TILT=NONE if the lamp may burn in any "
                   "position."};
    }
    const auto parted = std::mismatch(root.begin(), root.end(), target.begin(), target.end());
    if (parted.first != root.end()) return leavesFolder(named);
    return loadText(target);
  };
}

Result<TiltTable> parseTilt(NumberStream& stream) {
  TiltTable tilt;
  const auto geometry = stream.whole("the lamp-to-luminaire geometry of TILT", 1, 3);
  if (!geometry) return geometry.error();
  tilt.lamp_geometry = *geometry;
  const auto count = stream.whole("the number of TILT angles", 1, kMaxTiltAngles);
  if (!count) return count.error();
  auto angles = stream.numbers(static_cast<std::size_t>(*count), "TILT angles");
  if (!angles) return angles.error();
  auto factors = stream.numbers(static_cast<std::size_t>(*count), "TILT factors");
  if (!factors) return factors.error();
  if (std::any_of(factors->begin(), factors->end(), [](double f) { return f < 0.0; })) {
    return stream.error("expected TILT factors of at least 0, found a negative one",
                        "Correct the TILT block.");
  }
  tilt.angles_deg = std::move(*angles);
  tilt.factors = std::move(*factors);
  return tilt;
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/io/photometry/candela.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace soffit::io {
namespace {

constexpr double kBeyondAnyLampCd = 1e12;
constexpr double kNoiseShare = 1e-3;  // of the peak: what a goniometer's dark signal leaves
constexpr double kOddRatio = 1.05;    // LED modules run cool pass 1 by a few percent

Error errorAt(NumberStream start, std::ptrdiff_t index, std::string what, std::string hint) {
  // Reading up to the value again costs nothing that matters: it happens once, on failure.
  const auto read = start.numbers(static_cast<std::size_t>(index) + 1, "candela values");
  return read ? start.error(std::move(what), std::move(hint)) : read.error();
}

}  // namespace

Result<void> checkEntries(int n_vertical, int n_horizontal) {
  if (n_vertical <= kMaxEntries / n_horizontal) return {};
  return Error{"",
               fmt::format("expected at most {} candela values, found a claim of {} x {}",
                           kMaxEntries, n_vertical, n_horizontal),
               "The counts are damaged. Download the file again."};
}

Result<void> scaleCandela(std::vector<double>& candela, double factor, const NumberStream& start,
                          std::vector<std::string>& warnings) {
  for (double& cd : candela) cd *= factor;
  const auto [low, high] = std::minmax_element(candela.begin(), candela.end());
  const double least = *low;
  const double peak = *high;
  if (!(peak < kBeyondAnyLampCd)) {
    return errorAt(start, high - candela.begin(),
                   fmt::format("expected candela below {:g}, found {:g}", kBeyondAnyLampCd, peak),
                   "A value or a factor is damaged. Download the file again.");
  }
  if (least < -kNoiseShare * std::max(peak, 0.0)) {
    return errorAt(start, low - candela.begin(),
                   fmt::format("expected candela of at least 0, found {:g}", least),
                   "The values are damaged. Download the file again.");
  }
  if (peak <= 0.0) {
    return errorAt(start, 0, "expected some candela above 0, found that all are 0",
                   "The file describes no light: check the values and the factors.");
  }
  if (least < 0.0) {
    warnings.push_back(fmt::format("small negative candela (down to {:g}) are set to 0", least));
    for (double& cd : candela) cd = std::max(cd, 0.0);
  }
  return {};
}

void warnOfRatio(PhotometricFile& file) {
  const auto ratio = file.lightOutputRatio();
  if (!ratio || *ratio <= kOddRatio) return;
  file.warnings.push_back(
      fmt::format("the candela integrate to {:.0f} lm, {:.1f} % of the {:.0f} lm declared for the "
                  "lamps; the candela are used as they stand",
                  file.lumens, 100.0 * *ratio, *file.lamp_lumens));
}

}  // namespace soffit::io

// SPDX-License-Identifier: MIT
#include "core/color/lux_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::color {
namespace {

/// About so many lines over a scale.
constexpr int kRoundLevels = 11;
constexpr double kSmallestOnLinear = 0.02;
/// Slack for values that are a rounding error outside the range.
constexpr double kSlack = 1e-9;

/// Three significant digits, without an exponent.
std::string labelOf(double value) {
  if (value <= 0.0) return "0";
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return fmt::format("{:.6g}", std::round(value / unit) * unit);
}

FalseColorRange inUnit(const LuxScale& scale) {
  const double unit = luxPer(scale.unit);
  return {scale.range.min / unit, scale.range.max / unit, scale.range.logarithmic};
}

double valueAt(const FalseColorRange& range, double place) {
  return range.logarithmic ? range.min * std::pow(range.max / range.min, place)
                           : glm::mix(range.min, range.max, place);
}

std::vector<LegendTick> stepTicks(const LuxScale& scale, int most) {
  const FalseColorRange shown = inUnit(scale);
  const int every = (scale.steps + most - 2) / std::max(most - 1, 1);
  std::vector<LegendTick> ticks;
  for (int k = 0; k <= scale.steps; k += every) {
    const double place = static_cast<double>(k) / scale.steps;
    const double value = valueAt(shown, place);
    ticks.push_back({value * luxPer(scale.unit), static_cast<float>(place), labelOf(value)});
  }
  return ticks;
}

std::vector<double> standardLevels(const FalseColorRange& range) {
  static constexpr std::array<double, 7> kSeries{1.0, 1.5, 2.0, 3.0, 5.0, 7.5, 10.0};
  const double least =
      range.logarithmic ? range.min : std::max(range.min, kSmallestOnLinear * range.max);
  std::vector<double> levels;
  for (int decade = -3; decade <= 6; ++decade) {
    for (std::size_t i = 0; i + 1 < kSeries.size(); ++i) {
      // The series has 1.5 and 7.5 from 10 and 7.5 on.
      if (decade < 0 && (kSeries[i] == 1.5 || kSeries[i] == 7.5)) continue;
      if (decade == 0 && kSeries[i] == 1.5) continue;
      const double level = kSeries[i] * std::pow(10.0, decade);
      if (level >= least * (1 - kSlack) && level <= range.max * (1 + kSlack))
        levels.push_back(level);
    }
  }
  return levels;
}

}  // namespace

float LuxScale::placeInMap(float place) const {
  if (steps < 2) return place;
  const auto n = static_cast<float>(steps);
  return std::min(std::floor(std::max(place, 0.0F) * n), n - 1.0F) / (n - 1.0F);
}

std::vector<LegendTick> legendTicks(const LuxScale& scale, int most) {
  if (scale.steps >= 2) return stepTicks(scale, std::max(most, 2));
  auto ticks = legendTicks(inUnit(scale), most);
  for (LegendTick& tick : ticks) tick.lux *= luxPer(scale.unit);
  return ticks;
}

std::vector<double> isoLevels(const LuxScale& scale, LevelSeries series,
                              const std::vector<double>& chosen) {
  std::vector<double> levels;
  switch (series) {
    case LevelSeries::round:
      for (const LegendTick& tick : legendTicks(scale, kRoundLevels)) levels.push_back(tick.lux);
      break;
    case LevelSeries::standard:
      for (const double level : standardLevels(inUnit(scale))) {
        levels.push_back(level * luxPer(scale.unit));
      }
      break;
    case LevelSeries::chosen:
      levels = chosen;
      break;
  }
  std::erase_if(levels, [](double level) { return !(level > 0.0) || !std::isfinite(level); });
  std::ranges::sort(levels);
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  if (levels.size() > kMostLevels) levels.erase(levels.begin(), levels.end() - kMostLevels);
  return levels;
}

}  // namespace soffit::color

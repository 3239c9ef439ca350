// SPDX-License-Identifier: MIT
#include "core/color/false_color.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace soffit::color {
namespace {

/// Printed by resources/ocio/generate.py --map; sRGB code values at even steps.
constexpr std::array<vec3, 33> kMap{{
    {0.1220F, 0.0269F, 0.2007F}, {0.1441F, 0.0271F, 0.2578F}, {0.1612F, 0.0272F, 0.3202F},
    {0.1730F, 0.0283F, 0.3870F}, {0.1788F, 0.0261F, 0.4605F}, {0.1727F, 0.0670F, 0.5142F},
    {0.1557F, 0.1217F, 0.5499F}, {0.1264F, 0.1692F, 0.5830F}, {0.0722F, 0.2142F, 0.6129F},
    {0.0287F, 0.2705F, 0.5930F}, {0.0307F, 0.3158F, 0.5740F}, {0.0337F, 0.3537F, 0.5707F},
    {0.0316F, 0.3889F, 0.5752F}, {0.0382F, 0.4230F, 0.5817F}, {0.0300F, 0.4568F, 0.5917F},
    {0.0291F, 0.4904F, 0.6013F}, {0.0356F, 0.5240F, 0.6100F}, {0.0259F, 0.5581F, 0.6188F},
    {0.0487F, 0.5919F, 0.6243F}, {0.0310F, 0.6270F, 0.6290F}, {0.0305F, 0.6623F, 0.6294F},
    {0.0312F, 0.6982F, 0.6248F}, {0.0516F, 0.7345F, 0.6133F}, {0.0278F, 0.7726F, 0.5912F},
    {0.0394F, 0.8112F, 0.5531F}, {0.2635F, 0.8375F, 0.5173F}, {0.4039F, 0.8590F, 0.4839F},
    {0.5187F, 0.8782F, 0.4500F}, {0.6226F, 0.8952F, 0.4167F}, {0.7203F, 0.9102F, 0.3859F},
    {0.8137F, 0.9233F, 0.3599F}, {0.9037F, 0.9346F, 0.3420F}, {0.9905F, 0.9445F, 0.3359F},
}};

/// Slack for values that are a rounding error outside the range.
constexpr double kSlack = 1e-9;

std::string labelOf(double lux) {
  return fmt::format("{:.6g}", lux);
}

LegendTick tickAt(double lux, const FalseColorRange& range) {
  return {lux, range.place(static_cast<float>(lux)), labelOf(lux)};
}

std::vector<LegendTick> linearTicks(const FalseColorRange& range, double step) {
  std::vector<LegendTick> ticks;
  const double slack = kSlack * (range.max - range.min);
  for (double k = std::ceil((range.min - slack) / step); k * step <= range.max + slack; k += 1.0) {
    // Adding 0 turns a negative zero into a plain one for the label.
    ticks.push_back(tickAt(k * step + 0.0, range));
  }
  return ticks;
}

std::vector<LegendTick> logTicks(const FalseColorRange& range, std::span<const double> mantissas,
                                 int every_decade) {
  std::vector<LegendTick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(range.min) + kSlack));
  const int last = static_cast<int>(std::floor(std::log10(range.max) + kSlack));
  for (int decade = first; decade <= last; ++decade) {
    if (decade % every_decade != 0) continue;
    for (const double mantissa : mantissas) {
      const double lux = mantissa * std::pow(10.0, decade);
      if (lux >= range.min * (1 - kSlack) && lux <= range.max * (1 + kSlack)) {
        ticks.push_back(tickAt(lux, range));
      }
    }
  }
  return ticks;
}

std::vector<LegendTick> bestLogTicks(const FalseColorRange& range, std::size_t most) {
  static constexpr std::array<double, 3> kAll{1.0, 2.0, 5.0};
  auto ticks = logTicks(range, kAll, 1);
  if (ticks.size() <= most) return ticks;
  for (int every = 1;; ++every) {
    ticks = logTicks(range, std::span(kAll).first(1), every);
    if (ticks.size() <= most) return ticks;
  }
}

}  // namespace

Result<void> FalseColorRange::check() const {
  const std::string found = fmt::format("found {:g} to {:g} lx", min, max);
  if (!std::isfinite(min) || !std::isfinite(max) || max <= min) {
    return Error{"false colour range", "expected two finite values in ascending order, " + found,
                 "Give a range such as 0 to 1000."};
  }
  if (logarithmic && min <= 0.0) {
    return Error{"false colour range", "a logarithmic scale cannot start at 0 or below, " + found,
                 "Start at 1 lx, or use a linear scale."};
  }
  return {};
}

float FalseColorRange::place(float lux) const {
  const double value = static_cast<double>(lux);
  if (!(value > min)) return 0.0F;  // NaN too
  if (value >= max) return 1.0F;
  return static_cast<float>(logarithmic ? std::log(value / min) / std::log(max / min)
                                        : (value - min) / (max - min));
}

vec3 falseColorAt(float place) {
  const float clamped = std::min(std::max(0.0F, place), 1.0F);  // NaN becomes 0
  const float x = clamped * static_cast<float>(kMap.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(x), kMap.size() - 2);
  return glm::mix(kMap[i], kMap[i + 1], x - static_cast<float>(i));
}

std::vector<LegendTick> legendTicks(const FalseColorRange& range, int most) {
  const auto limit = static_cast<std::size_t>(std::max(most, 2));
  if (range.logarithmic) {
    auto ticks = bestLogTicks(range, limit);
    // Less than a decade holds too few of 1, 2, 5: even steps read better there.
    if (ticks.size() >= 3) return ticks;
  }
  static constexpr std::array<double, 4> kSteps{1.0, 2.0, 2.5, 5.0};
  double power =
      std::pow(10.0, std::floor(std::log10((range.max - range.min) / static_cast<double>(limit))));
  for (;; power *= 10.0) {
    for (const double step : kSteps) {
      auto ticks = linearTicks(range, step * power);
      if (ticks.size() <= limit) return ticks;
    }
  }
}

FalseColorRange roundRange(double highest) {
  FalseColorRange range{.min = 0.0, .max = 1.0};
  if (!std::isfinite(highest) || highest <= 0.0) return range;
  const double power = std::pow(10.0, std::floor(std::log10(highest)));
  for (const double mantissa : {1.0, 1.5, 2.0, 3.0, 5.0, 7.5, 10.0}) {
    range.max = mantissa * power;
    if (range.max >= highest * (1 - kSlack)) break;
  }
  return range;
}

}  // namespace soffit::color

// SPDX-License-Identifier: MIT
#include "ui/jobs/group_sums.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace soffit::ui {
namespace {

/// Two factors are one when they differ by no more than the rounding of their division.
constexpr double kSameFactor = 1e-9;
/// Each leaves about 1e-7 of its light behind: together still less than a hundred-thousandth.
constexpr std::size_t kMostDifferences = 64;

dvec3 weightOf(const relight::Lighting& lighting, std::size_t i) {
  const light::Emitter& e = lighting.emitters()[i];
  return e.gain * e.color;
}

/// The factor per channel that leads from the old weights to the new ones, if there is one.
std::optional<dvec3> factorBetween(const std::vector<dvec3>& before,
                                   const std::vector<dvec3>& after) {
  dvec3 factor(0.0);
  for (int c = 0; c < 3; ++c) {
    bool known = false;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (before[i][c] == 0.0) {
        if (after[i][c] != 0.0) return std::nullopt;
        continue;
      }
      const double own = after[i][c] / before[i][c];
      if (known && std::abs(own - factor[c]) > kSameFactor * std::abs(factor[c])) {
        return std::nullopt;
      }
      factor[c] = own;
      known = true;
    }
  }
  return factor;
}

}  // namespace

void GroupSums::make(Sum& sum, const relight::Lighting& lighting) {
  const std::size_t slots = lighting.solver().operators().texels.slotCount();
  for (auto& plane : sum.planes) plane.assign(slots, 0.0F);
  sum.weights.clear();
  sum.differences = 0;
  for (const std::size_t i : sum.members) {
    sum.weights.push_back(weightOf(lighting, i));
    if (lighting.emitters()[i].gain <= 0.0) continue;
    lighting.addTo(i, sum.weights.back(), sum.planes);
    ++added_;
  }
}

/// Adds what changed to the sum; false when it is better made anew.
bool GroupSums::adjust(Sum& sum, const relight::Lighting& lighting, const std::vector<dvec3>& now) {
  std::vector<std::size_t> others;
  bool dark = true;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] != sum.weights[i]) others.push_back(i);
    dark = dark && now[i] == dvec3(0.0);
  }
  // In the dark there is to be no light at all, not even what rounding leaves.
  if (dark || 2 * others.size() > now.size()) return false;
  if (sum.differences + others.size() > kMostDifferences) return false;
  for (const std::size_t i : others) {
    lighting.addTo(sum.members[i], now[i] - sum.weights[i], sum.planes);
    ++added_;
  }
  sum.differences += others.size();
  sum.weights = now;
  return true;
}

relight::Planes GroupSums::total(const relight::Lighting& lighting,
                                 const std::vector<std::string>& groups,
                                 const std::vector<bool>& changed) {
  added_ = 0;
  std::map<std::string, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < groups.size(); ++i) members[groups[i]].push_back(i);
  std::erase_if(sums_, [&](const Sum& sum) {
    const auto now = members.find(sum.group);
    return now == members.end() || now->second != sum.members ||
           std::ranges::any_of(sum.members, [&](std::size_t i) { return changed[i]; });
  });
  const std::size_t slots = lighting.solver().operators().texels.slotCount();
  relight::Planes total;
  for (auto& plane : total) plane.assign(slots, 0.0F);
  for (const auto& [group, list] : members) {
    auto sum = std::ranges::find(sums_, group, &Sum::group);
    if (sum == sums_.end()) {
      sums_.push_back({group, list, {}, {}, 0});
      sum = std::prev(sums_.end());
      make(*sum, lighting);
    }
    std::vector<dvec3> now;
    for (const std::size_t i : list) now.push_back(weightOf(lighting, i));
    auto factor = factorBetween(sum->weights, now);
    if (!factor) {
      if (!adjust(*sum, lighting, now)) make(*sum, lighting);
      factor = dvec3(1.0);
    }
    for (int c = 0; c < 3; ++c) {
      const auto f = static_cast<float>((*factor)[c]);
      if (f == 0.0F) continue;
      const auto& from = sum->planes[static_cast<std::size_t>(c)];
      auto& to = total[static_cast<std::size_t>(c)];
      parallelFor(slots, 16384, [&](std::size_t begin, std::size_t end) {
        for (std::size_t s = begin; s < end; ++s) to[s] += f * from[s];
      });
    }
  }
  lighting.solver().fill(total);
  return total;
}

}  // namespace soffit::ui

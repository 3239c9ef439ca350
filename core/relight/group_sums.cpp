// SPDX-License-Identifier: MIT
#include "core/relight/group_sums.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace soffit::relight {
namespace {

/// Two factors are one when they differ by no more than the rounding of their division.
constexpr double kSameFactor = 1e-9;
/// Each leaves about 1e-7 of its light behind: together still less than a hundred-thousandth.
constexpr std::size_t kMostDifferences = 64;
/// A sum is read in three channels, a luminaire in one.
constexpr std::size_t kFewMembers = 3;

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

void GroupSums::make(Sum& sum, const Lighting& lighting) {
  sum.light = noLight(lighting.solver().operators());
  sum.made = true;
  sum.differences = 0;
  for (std::size_t k = 0; k < sum.members.size(); ++k) {
    if (sum.weights[k] == dvec3(0.0)) continue;
    addTo(sum.light, {&lighting.column(sum.members[k]), sum.weights[k]},
          lighting.solver().operators());
    ++added_;
  }
}

/// Adds what changed to the sum; false when it is better left.
bool GroupSums::adjust(Sum& sum, const Lighting& lighting, const std::vector<dvec3>& now) {
  std::vector<std::size_t> others;
  bool dark = true;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] != sum.weights[i]) others.push_back(i);
    dark = dark && now[i] == dvec3(0.0);
  }
  // In the dark there is to be no light at all, not even what rounding leaves.
  if (dark || 2 * others.size() > now.size()) return false;
  if (sum.differences + others.size() > kMostDifferences) return false;
  if (!sum.made) make(sum, lighting);
  for (const std::size_t i : others) {
    addTo(sum.light, {&lighting.column(sum.members[i]), now[i] - sum.weights[i]},
          lighting.solver().operators());
    ++added_;
  }
  sum.differences += others.size();
  sum.weights = now;
  return true;
}

Planes GroupSums::total(const Lighting& lighting, const std::vector<std::string>& groups,
                        const std::vector<bool>& changed) {
  added_ = 0;
  std::map<std::string, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < groups.size(); ++i) members[groups[i]].push_back(i);
  std::erase_if(sums_, [&](const Sum& sum) {
    const auto now = members.find(sum.group);
    return now == members.end() || now->second != sum.members ||
           std::ranges::any_of(sum.members, [&](std::size_t i) { return changed[i]; });
  });
  std::vector<WeightedColumn> single = lighting.outdoorLights();
  const auto mixMembers = [&](const std::vector<std::size_t>& list) {
    for (const std::size_t i : list) {
      if (lighting.weight(i) == dvec3(0.0)) continue;
      single.push_back({&lighting.column(i), lighting.weight(i)});
      ++added_;
    }
  };
  sums_.reserve(members.size());  // their addresses are handed on
  std::vector<WeightedSum> factored;
  for (const auto& [group, list] : members) {
    if (list.size() <= kFewMembers) {
      mixMembers(list);
      continue;
    }
    std::vector<dvec3> now;
    for (const std::size_t i : list) now.push_back(lighting.weight(i));
    auto sum = std::ranges::find(sums_, group, &Sum::group);
    if (sum == sums_.end()) {
      sums_.push_back({group, list, now, {}, false, 0});
      mixMembers(list);
      continue;
    }
    if (const auto factor = factorBetween(sum->weights, now)) {
      if (!sum->made) make(*sum, lighting);
      factored.push_back({&sum->light, *factor});
    } else if (adjust(*sum, lighting, now)) {
      factored.push_back({&sum->light, dvec3(1.0)});
    } else {
      *sum = {group, list, now, {}, false, 0};
      mixMembers(list);
    }
  }
  Planes total;
  spread(factored, single, lighting.solver().operators(), total);
  return total;
}

}  // namespace soffit::relight

// SPDX-License-Identifier: MIT
#include "ui/jobs/probe_shares.h"

#include "core/color/luminance.h"

#include <algorithm>

namespace soffit::ui {
namespace {

double luxAt(const ProbePlace& place, const relight::Planes& lux) {
  double sum = 0.0;
  for (std::size_t k = 0; k < place.slots.size(); ++k) {
    const std::size_t s = place.slots[k];
    sum += static_cast<double>(place.weights[k]) *
           color::luminance(dvec3(lux[0][s], lux[1][s], lux[2][s]));
  }
  return sum;
}

/// Of one light alone.
double luxAt(const ProbePlace& place, const relight::Lighting& lighting,
             const relight::WeightedColumn& light) {
  if (light.weight == dvec3(0.0)) return 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < place.slots.size(); ++k) {
    sum += static_cast<double>(place.weights[k]) *
           color::luminance(relight::luxAt(light, lighting.solver().operators(), place.slots[k]));
  }
  return sum;
}

}  // namespace

std::vector<std::vector<double>> ProbeShares::last(const std::vector<io::Probe>& probes,
                                                   const std::string& layout) const {
  return probes == probes_ && layout == layout_ ? shares_ : std::vector<std::vector<double>>{};
}

bool ProbeShares::knows(const std::vector<io::Probe>& probes, const LightColumns& columns,
                        const std::string& layout, std::size_t in_hand) const {
  const relight::Lighting* lighting = columns.lightingOf(layout);
  return probes == probes_ && layout == layout_ && columns.solver() == solver_ &&
         lighting != nullptr && lighting->environment() == outside_ &&
         std::ranges::all_of(shares_,
                             [&](const auto& own) { return own.empty() || in_hand < own.size(); });
}

void ProbeShares::giveRest(const relight::Planes& lux, std::size_t in_hand) {
  for (std::size_t p = 0; p < places_.size(); ++p) {
    if (!places_[p]) continue;
    double others = 0.0;
    for (std::size_t i = 0; i < shares_[p].size(); ++i) {
      if (i != in_hand) others += shares_[p][i];
    }
    shares_[p][in_hand] = std::max(0.0, luxAt(*places_[p], lux) - others);
  }
}

std::vector<std::vector<double>> ProbeShares::of(const std::vector<io::Probe>& probes,
                                                 const LightColumns& columns,
                                                 const std::string& layout,
                                                 const relight::Planes& lux,
                                                 std::optional<std::size_t> in_hand) {
  if (probes.empty()) return {};
  if (in_hand && knows(probes, columns, layout, *in_hand)) {
    giveRest(lux, *in_hand);
    return shares_;
  }
  probes_ = probes;
  layout_ = layout;
  solver_ = columns.solver();
  places_.clear();
  for (const io::Probe& probe : probes) places_.push_back(placeOf(probe, *columns.solver()));
  shares_.assign(probes.size(), {});
  const relight::Lighting* lighting = columns.lightingOf(layout);
  outside_ = lighting == nullptr ? nullptr : lighting->environment();
  if (lighting == nullptr) return shares_;
  for (std::size_t p = 0; p < places_.size(); ++p) {
    if (!places_[p]) continue;
    for (std::size_t i = 0; i < lighting->emitters().size(); ++i) {
      shares_[p].push_back(
          luxAt(*places_[p], *lighting, {&lighting->column(i), lighting->weight(i)}));
    }
    if (outside_ == nullptr) continue;
    double outside = 0.0;
    for (const relight::WeightedColumn& light : lighting->outdoorLights()) {
      outside += luxAt(*places_[p], *lighting, light);
    }
    shares_[p].push_back(outside);
  }
  return shares_;
}

}  // namespace soffit::ui

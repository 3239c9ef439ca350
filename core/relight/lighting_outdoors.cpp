// SPDX-License-Identifier: MIT
// Lighting's part from outside.
#include "core/relight/lighting.h"

#include <algorithm>

namespace soffit::relight {

std::vector<light::MaskBlocker> Lighting::allBodies() const {
  std::vector<light::MaskBlocker> out;
  for (const Entry& entry : entries_) out.insert(out.end(), entry.body.begin(), entry.body.end());
  return out;
}

Result<void> Lighting::setEnvironment(std::shared_ptr<const daylight::Environment> environment,
                                      const Job& job) {
  environment_ = std::move(environment);
  if (environment_ != nullptr && environment_->dark()) environment_.reset();
  letGo();
  auto done = computeOutdoors(job);
  if (!done) environment_.reset();
  return done;
}

Result<void> Lighting::computeOutdoors(const Job& job) {
  outdoors_ = {};
  if (environment_ == nullptr) return {};
  Outdoors found = outdoorLight(*solver_, environment_, allBodies(), job);
  const std::vector<float> open = openShare();
  for (Column& column : found.columns) {
    if (job.cancelled()) break;
    solver_->indirect(column, open);
  }
  if (job.cancelled()) return Error{"light", "cancelled", ""};
  outdoors_ = std::move(found);
  return {};
}

std::vector<WeightedColumn> Lighting::SkyHand::discLights() const {
  std::vector<WeightedColumn> out;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    out.push_back({&discs[i], spots[i].normal_illuminance});
  }
  return out;
}

/// A disc that only shines more or less keeps its column.
Result<void> Lighting::holdSpots(std::vector<daylight::Spot> spots, const Job& job) {
  SkyHand& hand = *sky_hand_;
  const auto same_place = [](const daylight::Spot& a, const daylight::Spot& b) {
    return a.direction == b.direction && a.radius == b.radius;
  };
  const auto same = [&](const daylight::Spot& a, const daylight::Spot& b) {
    return same_place(a, b) && a.normal_illuminance == b.normal_illuminance;
  };
  if (std::ranges::equal(spots, hand.spots, same)) return {};
  hand.rest.reset();
  std::vector<Column> discs(spots.size());
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (job.cancelled()) {
      hand.spots.clear();
      return Error{"light", "cancelled", ""};
    }
    if (i < hand.spots.size() && same_place(spots[i], hand.spots[i])) {
      discs[i] = std::move(hand.discs[i]);
      continue;
    }
    solver_->direct(farDisc(spots[i], solver_->scene().mesh->bounds()), allBodies(), discs[i]);
    solver_->indirect(discs[i], openShare());
  }
  hand.spots = std::move(spots);
  hand.discs = std::move(discs);
  return {};
}

Result<void> Lighting::holdSky(const daylight::Environment& environment, const Job& job) {
  if (sky_transfer_ == nullptr || !sky_transfer_->fits(environment)) {
    sky_transfer_ = SkyTransfer::make(*solver_, SkyTransfer::kBands, !environment.evenGround(),
                                      openShare(), job);
    if (sky_transfer_ == nullptr) return Error{"light", "cancelled", ""};
  }
  if (!sky_hand_) {
    sky_hand_.emplace();
    sky_hand_->lamps = noLight(solver_->operators());
    for (std::size_t i = 0; i < emitters_.size(); ++i) {
      if (emitters_[i].gain <= 0.0) continue;
      addTo(sky_hand_->lamps, {&entries_[i].column, weight(i)}, solver_->operators());
    }
  }
  return holdSpots(SkyTransfer::exactSpots(environment), job);
}

Result<Planes> Lighting::totalUnderSky(const daylight::Environment& environment, const Job& job) {
  if (auto held = holdSky(environment, job); !held) return held.error();
  std::vector<WeightedColumn> outside = sky_transfer_->mix(environment);
  for (const WeightedColumn& disc : sky_hand_->discLights()) outside.push_back(disc);
  Planes total;
  const WeightedSum lamps{&sky_hand_->lamps};
  spread({&lamps, 1}, outside, solver_->operators(), total);
  // Bands that were left out may take away more than there is.
  for (auto& plane : total) {
    for (float& lux : plane) lux = std::max(lux, 0.0F);
  }
  return total;
}

Result<SkyParts> Lighting::partsUnderSky(const daylight::Environment& environment, const Job& job) {
  if (auto held = holdSky(environment, job); !held) return held.error();
  if (sky_hand_->rest == nullptr) {
    const WeightedSum lamps{&sky_hand_->lamps};
    const std::vector<WeightedColumn> discs = sky_hand_->discLights();
    Planes reflected;
    spread({&lamps, 1}, discs, solver_->operators(), reflected, LightPart::unbounded);
    Planes direct;
    spread({&lamps, 1}, discs, solver_->operators(), direct, LightPart::direct);
    sky_hand_->rest = std::make_shared<const SkyRest>(skyRest(reflected, direct));
  }
  return SkyParts{sky_transfer_, sky_transfer_->weights(environment), sky_hand_->rest};
}

std::vector<WeightedColumn> Lighting::outdoorLights() const {
  std::vector<WeightedColumn> out;
  for (std::size_t k = 0; k < outdoors_.columns.size(); ++k) {
    out.push_back({&outdoors_.columns[k], outdoors_.weight(k)});
  }
  return out;
}

}  // namespace soffit::relight

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

Result<Planes> Lighting::totalUnderSky(const daylight::Environment& environment, const Job& job) {
  const std::vector<float> open = openShare();
  if (sky_transfer_ == nullptr || !sky_transfer_->fits(environment)) {
    sky_transfer_ =
        SkyTransfer::make(*solver_, SkyTransfer::kBands, !environment.evenGround(), open, job);
    if (sky_transfer_ == nullptr) return Error{"light", "cancelled", ""};
  }
  if (!lamps_) {
    lamps_ = noLight(solver_->operators());
    for (std::size_t i = 0; i < emitters_.size(); ++i) {
      if (emitters_[i].gain <= 0.0) continue;
      addTo(*lamps_, {&entries_[i].column, weight(i)}, solver_->operators());
    }
  }
  std::vector<WeightedColumn> outside = sky_transfer_->mix(environment);
  const std::vector<daylight::Spot> spots = SkyTransfer::exactSpots(environment);
  std::vector<Column> discs(spots.size());
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (job.cancelled()) return Error{"light", "cancelled", ""};
    solver_->direct(farDisc(spots[i], solver_->scene().mesh->bounds()), allBodies(), discs[i]);
    solver_->indirect(discs[i], open);
    outside.push_back({&discs[i], spots[i].normal_illuminance});
  }
  Planes total;
  const WeightedSum lamps{&*lamps_};
  spread({&lamps, 1}, outside, solver_->operators(), total);
  // Bands that were left out may take away more than there is.
  for (auto& plane : total) {
    for (float& lux : plane) lux = std::max(lux, 0.0F);
  }
  return total;
}

std::vector<WeightedColumn> Lighting::outdoorLights() const {
  std::vector<WeightedColumn> out;
  for (std::size_t k = 0; k < outdoors_.columns.size(); ++k) {
    out.push_back({&outdoors_.columns[k], outdoors_.weight(k)});
  }
  return out;
}

}  // namespace soffit::relight

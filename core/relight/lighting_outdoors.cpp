// SPDX-License-Identifier: MIT
// Lighting's part from outside.
#include "core/relight/lighting.h"

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
  Outdoors found = outdoorLight(*solver_, *environment_, allBodies(), job);
  const std::vector<float> open = openShare();
  for (Column& column : found.columns) {
    if (job.cancelled()) break;
    solver_->indirect(column, open);
  }
  if (job.cancelled()) return Error{"light", "cancelled", ""};
  outdoors_ = std::move(found);
  return {};
}

std::vector<WeightedColumn> Lighting::outdoorLights() const {
  std::vector<WeightedColumn> out;
  for (std::size_t k = 0; k < outdoors_.columns.size(); ++k) {
    out.push_back({&outdoors_.columns[k], outdoors_.weight(k)});
  }
  return out;
}

}  // namespace soffit::relight

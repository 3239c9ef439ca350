// SPDX-License-Identifier: MIT
#include "ui/jobs/held_sky.h"

namespace soffit::ui {

void HeldSkies::prepare(const relight::SkyParts& parts, const transfer::Operators& operators,
                        const std::shared_ptr<const relight::LightRows>& points, const Job& job) {
  if (fits(parts, points)) return;
  forget();
  vectors_ = relight::SkyVectors::make(parts.transfer, operators, points, job);
}

std::shared_ptr<const HeldSky> HeldSkies::step(const relight::SkyParts& parts) {
  if (rest_ == nullptr || rest_planes_ != parts.rest) {
    std::vector<vec3> rest(vectors_->points());
    relight::lightPoints(*vectors_->rows(), *parts.rest, rest);
    rest_ = std::make_shared<const std::vector<vec3>>(std::move(rest));
    rest_planes_ = parts.rest;
  }
  return std::make_shared<const HeldSky>(HeldSky{vectors_, parts.weights, rest_});
}

void HeldSkies::forget() {
  vectors_.reset();
  rest_planes_.reset();
  rest_.reset();
}

}  // namespace soffit::ui

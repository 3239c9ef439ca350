// SPDX-License-Identifier: MIT
#include "core/daylight/environment.h"

#include <algorithm>
#include <cmath>

namespace soffit::daylight {
namespace {

double lum(const dvec3& rgb) {
  return 0.2126390058715104 * rgb.x + 0.7151686787677560 * rgb.y + 0.0721923153607336 * rgb.z;
}

double squaredSine(double radius) {
  return std::sin(radius) * std::sin(radius);
}

}  // namespace

double Sun::radiance() const {
  return normal_illuminance / (kPi * squaredSine(kRadius));
}

bool Sun::covers(const dvec3& d) const {
  // By the chord: the cosine has too few digits left at a quarter of a degree.
  const dvec3 off = d - direction;
  const double half = std::sin(0.5 * kRadius);
  return glm::dot(off, off) < 4.0 * half * half;
}

Environment::Environment(const scene::Environment& description, const Environment* like) {
  double turn = 0.0;
  if (const auto* sky = std::get_if<scene::Sky>(&description.light)) {
    const dvec3 to_sun =
        skyDirection(radians(sky->sun_azimuth_deg), radians(sky->sun_altitude_deg));
    sky_.emplace(sky->cie, to_sun, sky->horizontal_illuminance);
    ground_ = sky->ground_reflectance * sky->horizontal_illuminance / kPi;
    if (sky->direct_normal_illuminance > 0.0 && sky->sun_altitude_deg > 0.0) {
      sun_ = Sun{to_sun, sky->direct_normal_illuminance};
      spots_.push_back({to_sun, Sun::kRadius, dvec3(sky->direct_normal_illuminance)});
    }
  } else if (const auto* probe = std::get_if<scene::Probe>(&description.light)) {
    turn = radians(probe->rotation_deg);
    const auto known = like == nullptr ? nullptr : like->picture_;
    if (known != nullptr && known->isOf(probe->image, probe->layout)) {
      picture_ = known->scale() == probe->scale
                     ? known
                     : std::make_shared<const PictureLight>(known->scaled(probe->scale));
    } else if (probe->image != nullptr) {
      picture_ = std::make_shared<const PictureLight>(probe->image, probe->layout, probe->scale);
    }
  } else {
    const auto& patch = std::get<scene::PatchLight>(description.light);
    turn = radians(patch.rotation_deg);
    patches_ = sh::AnalyticLight{patch.overhead_gain,  patch.overhead_threshold, patch.side_gain,
                                 patch.side_threshold, patch.side_azimuth_rad,   patch.scale};
  }
  cos_turn_ = std::cos(turn);
  sin_turn_ = std::sin(turn);
  if (picture_ == nullptr) return;
  for (Spot spot : picture_->spots()) {
    const dvec3 d = spot.direction;
    spot.direction = {cos_turn_ * d.x - sin_turn_ * d.y, sin_turn_ * d.x + cos_turn_ * d.y, d.z};
    spots_.push_back(spot);
  }
}

bool Environment::dark() const {
  if (sun_) return false;
  if (sky_) return !(sky_->luminance({0.0, 0.0, 1.0}) > 0.0) && !(ground_ > 0.0);
  if (picture_ != nullptr) return picture_->dark();
  return !table().anyLight();
}

const SkyTable& Environment::table() const {
  std::call_once(table_->once, [&] { table_->table.emplace(tableWeights()); });
  return *table_->table;
}

std::vector<double> Environment::tableWeights() const {
  std::vector<double> weights;
  if (picture_ != nullptr) {
    // The picture's cells turn by the angle with it: look each up where it came from.
    const std::vector<double> own = picture_->weights();
    for (std::size_t i = 0; i < SkyTable::kCells; ++i) {
      double most = 0.0;
      for (int k = 0; k < 9; ++k) {
        const dvec2 at(0.01 + 0.49 * (k % 3), 0.01 + 0.49 * (k / 3));
        most = std::max(most, own[SkyTable::cellOf(turned(SkyTable::direction(i, at)))]);
      }
      weights.push_back(most);
    }
    return weights;
  }
  for (std::size_t i = 0; i < SkyTable::kCells; ++i) {
    double mean = 0.0;
    for (int k = 0; k < 4; ++k) {
      const dvec2 at(0.25 + 0.5 * (k % 2), 0.25 + 0.5 * (k / 2));
      mean += 0.25 * lum(radiance(SkyTable::direction(i, at)));
    }
    weights.push_back(mean);
  }
  return weights;
}

dvec3 Environment::turned(const dvec3& d) const {
  return {cos_turn_ * d.x + sin_turn_ * d.y, -sin_turn_ * d.x + cos_turn_ * d.y, d.z};
}

dvec3 Environment::radiance(const dvec3& d) const {
  if (sky_) return dvec3(d.z >= 0.0 ? sky_->luminance(d) : ground_);
  if (picture_ != nullptr) return picture_->radiance(turned(d));
  return patches_ ? dvec3((*patches_)(turned(d))) : dvec3(0.0);
}

dvec3 Environment::smoothRadiance(const dvec3& d) const {
  if (sky_) return dvec3(d.z >= 0.0 ? sky_->quickLuminance(d) : ground_);
  return picture_ != nullptr ? picture_->smooth(turned(d)) : radiance(d);
}

}  // namespace soffit::daylight

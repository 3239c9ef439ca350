// SPDX-License-Identifier: MIT
#include "ui/viewport/walking.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kFast = 3.0;
constexpr double kSlowest = 0.25;  // m/s
constexpr double kFastest = 20.0;
constexpr double kStepOfSpeed = 1.25;
/// Time constants of gathering way, and of rising and sinking to the height over the floor, s.
constexpr double kInertia = 0.09;
constexpr double kSettling = 0.15;
/// A picture that took longer is no reason to jump through a wall.
constexpr double kLongest = 0.1;
constexpr double kLeastSpeed = 0.01;
constexpr double kHeadroom = 0.12;
constexpr double kLeastHeight = 0.15;
/// Walls are felt for at the eye and this much lower: above tables and steps.
constexpr double kChest = 0.5;
/// Flatter than this is a ramp or a step and no wall.
constexpr double kRamp = 0.7;
constexpr double kSideCosine = 0.766;  // feelers 40 degrees to either side
constexpr double kSideSine = 0.643;

double blend(double seconds, double constant) {
  return 1.0 - std::exp(-seconds / constant);
}

/// A horizontal step, shortened and turned along the walls that it would run into.
dvec3 alongWalls(const dvec3& eye, dvec3 step, const Walking::Feel& feel) {
  for (int pass = 0; pass < 2; ++pass) {
    for (const double low : {0.0, kChest}) {
      for (const double side : {0.0, -1.0, 1.0}) {
        const double length = glm::length(step);
        if (length < 1e-9) return dvec3(0.0);
        const dvec3 ahead = step / length;
        const dvec3 across(-ahead.y, ahead.x, 0.0);
        const dvec3 feeler = side == 0.0 ? ahead : kSideCosine * ahead + side * kSideSine * across;
        const auto met = feel(eye - dvec3(0.0, 0.0, low), feeler);
        if (!met || std::abs(met->normal.z) > kRamp) continue;
        const dvec3 n = glm::normalize(dvec3(met->normal.x, met->normal.y, 0.0));
        const double gap = met->distance * std::max(-glm::dot(feeler, n), 0.0);
        // An edge that is far off is not in the way, whatever the plane through it.
        if (met->distance > 2.0 * Walking::kRadius + 2.0 * length) continue;
        const double into = -glm::dot(step, n);
        const double allowed = std::max(gap - Walking::kRadius, 0.0);
        if (into > allowed) step += (into - allowed) * n;
      }
    }
  }
  return step;
}

}  // namespace

void Walking::changeSpeed(double steps) {
  speed_ = std::clamp(speed_ * std::pow(kStepOfSpeed, steps), kSlowest, kFastest);
}

bool Walking::isMoving() const {
  return glm::length(velocity_) > kLeastSpeed;
}

void Walking::advance(ViewCamera& camera, const Wish& wish, double seconds, const Feel& feel) {
  seconds = std::clamp(seconds, 0.0, kLongest);
  const dvec3 right = camera.right();
  const dvec3 ahead(-right.y, right.x, 0.0);
  dvec3 way = wish.way.x * right + wish.way.y * ahead + wish.way.z * dvec3(0.0, 0.0, 1.0);
  if (glm::length(way) > 0.0) way = glm::normalize(way);
  const dvec3 wanted = speed_ * (wish.fast ? kFast : 1.0) * way;
  velocity_ += blend(seconds, kInertia) * (wanted - velocity_);
  if (wish.none() && !isMoving()) velocity_ = dvec3(0.0);

  dvec3& eye = camera.position;
  eye += alongWalls(eye, seconds * dvec3(velocity_.x, velocity_.y, 0.0), feel);
  const auto floor = feel(eye, {0.0, 0.0, -1.0});
  if (wish.way.z != 0.0) {
    double rise = seconds * velocity_.z;
    if (rise > 0.0) {
      if (const auto ceiling = feel(eye, {0.0, 0.0, 1.0}))
        rise = std::min(rise, std::max(ceiling->distance - kHeadroom, 0.0));
    } else if (floor) {
      rise = std::max(rise, -std::max(floor->distance - kLeastHeight, 0.0));
    }
    eye.z += rise;
    if (floor) height_ = floor->distance + rise;
  } else if (floor && (wish.way.x != 0.0 || wish.way.y != 0.0)) {
    eye.z += blend(seconds, kSettling) * (height_ - floor->distance);
  }
}

}  // namespace soffit::ui

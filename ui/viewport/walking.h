// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/view_camera.h"

#include <functional>
#include <optional>

namespace soffit::ui {

/// A person's way through a building: the eye stays at its height over the floor, walls hold it,
/// and it gathers and loses way smoothly, by time and not by the repeat of keys.
///
/// Knows neither keys nor timers. World coordinates, m, s.
class Walking {
 public:
  static constexpr double kEyeHeight = 1.6;
  static constexpr double kRadius = 0.25;  ///< no nearer to a wall than this

  /// A surface that is met: how far away it is, and its normal toward the eye.
  struct Met {
    double distance = 0.0;
    dvec3 normal{0.0};
  };
  /// What lies in a direction (unit) from a place; nothing: the way is free.
  using Feel = std::function<std::optional<Met>(const dvec3& from, const dvec3& direction)>;

  /// Where one wants to go: ahead, to the right, up; each -1, 0 or 1.
  struct Wish {
    dvec3 way{0.0};
    bool fast = false;
    [[nodiscard]] bool none() const { return way == dvec3(0.0); }
  };

  /// Steps of a speed of a person's; Wish::fast is three times as fast.
  void changeSpeed(double steps);
  [[nodiscard]] double speed() const { return speed_; }  ///< m/s

  /// Moves the eye on by `seconds`. Going up or down sets the height over the floor at which one
  /// goes on.
  void advance(ViewCamera& camera, const Wish& wish, double seconds, const Feel& feel);
  /// Stands still.
  void stop() { velocity_ = dvec3(0.0); }
  [[nodiscard]] bool isMoving() const;
  /// At a person's height again: the eye was put elsewhere.
  void standUp() { height_ = kEyeHeight; }
  [[nodiscard]] double height() const { return height_; }

 private:
  double speed_ = 2.0;
  double height_ = kEyeHeight;
  dvec3 velocity_{0.0};
};

}  // namespace soffit::ui

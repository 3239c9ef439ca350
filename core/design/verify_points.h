// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/design/error_figures.h"
#include "core/design/surface_receivers.h"
#include "core/light/luminaire.h"
#include "core/relight/sensors.h"
#include "core/relight/solver.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace soffit::design {

/// How well the reference is to know each point.
struct ReferenceEffort {
  double error = 0.005;       ///< wanted standard error, relative to max(E, 5 % of the set's mean)
  double time_limit_s = 0.0;  ///< for everything together; 0: no limit
  std::uint64_t seed = 1;
};

/// Illuminance at a point, lux.
struct LightParts {
  double direct = 0.0;    ///< without reflection
  double indirect = 0.0;  ///< after at least one
};

/// Values of one set of luminaires at one kind of points.
struct SetSamples {
  ErrorSamples lux;
  std::vector<LightParts> value;      ///< interactive
  std::vector<LightParts> reference;  ///< sums to lux.reference
};

/// The same at both kinds.
struct PointSamples {
  SetSamples surfaces;
  SetSamples sensors;
};

/// a + b for luminaires that shine together: values and references add, noise in squares.
PointSamples sumOf(const PointSamples& a, const PointSamples& b);

/// Points on surfaces that the luminaires of the scene light, at most `count`, uniformly by area.
/// A place is dark when both solutions say so. Errors: makeEmitter's; cancelled.
Result<std::vector<SurfaceReceiver>> chooseReceivers(
    const std::shared_ptr<const relight::Solver>& solver, const scene::Scene& scene,
    std::size_t count, std::uint64_t seed, const Job& job);

/// The points at which a scene is verified, ready to be evaluated for any set of luminaires.
class VerifyPoints {
 public:
  /// surfaces: read as pictures show them.   sensors: read as `measure` does.
  VerifyPoints(std::shared_ptr<const relight::Solver> solver, const scene::Scene& scene,
               std::vector<SurfaceReceiver> surfaces, std::vector<scene::Sensor> sensors,
               int sensor_rays, const ReferenceEffort& effort);

  [[nodiscard]] std::span<const SurfaceReceiver> surfaces() const { return surfaces_; }
  [[nodiscard]] std::span<const scene::Sensor> sensors() const { return sensors_; }

  /// Points are put into sets (rooms) whose reference is driven to `effort.error` each against
  /// its own mean. One number per point, any values; empty: one set.
  void setGroups(std::vector<std::size_t> of_surfaces, std::vector<std::size_t> of_sensors);

  /// Both solutions of these luminaires: those that are off or at dimming 0 shed no light but
  /// keep their bodies. Errors: makeEmitter's; cancelled.
  /// evaluations_left: how many such calls share what is left of the time, this one included.
  /// outside: the scene's environment shines too.
  Result<PointSamples> evaluate(std::span<const light::Luminaire> luminaires,
                                std::size_t evaluations_left, const Job& job, bool outside = false);

  /// Whether every reference so far met the wanted error, and what they took.
  [[nodiscard]] bool reached() const { return reached_; }
  [[nodiscard]] std::uint64_t rays() const { return rays_; }

 private:
  Result<void> addReference(std::span<const light::Luminaire> luminaires, bool outside,
                            double seconds, const Job& job, PointSamples& out);

  std::shared_ptr<const relight::Solver> solver_;
  const scene::Scene& scene_;
  std::vector<SurfaceReceiver> surfaces_;
  std::vector<scene::Sensor> sensors_;
  std::optional<relight::Sensors> prepared_;
  ReferenceEffort effort_;
  std::vector<std::size_t> surface_groups_;
  std::vector<std::size_t> sensor_groups_;
  double seconds_spent_ = 0.0;  ///< on references
  std::uint64_t calls_ = 0;
  std::uint64_t rays_ = 0;
  bool reached_ = true;
};

}  // namespace soffit::design

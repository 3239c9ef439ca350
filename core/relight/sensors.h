// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/solver.h"
#include "core/scene/scene.h"

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace soffit::relight {

/// What a sensor measures (interfaces.md § 2): all but planar are means of planar illuminance
/// over orientations: around the axis (cylindrical), over the half circle about n in the
/// horizontal plane (semicylindrical), over all (spherical) or half (hemispherical) directions.
enum class Quantity { planar, cylindrical, semicylindrical, spherical, hemispherical };

/// Direct and indirect illuminance, RGB in lux.
struct SensorLight {
  dvec3 direct{0.0};
  dvec3 indirect{0.0};
};

/// Sensors made ready: their own gather rays over the texels, so that a reading needs no
/// interpolation (design.md § 2). Depends on geometry alone.
class Sensors {
 public:
  /// sensors: world coordinates. rays: per side of the stratified square (rays^2 per planar
  /// sensor). A sensor within 1e-4 m of a surface lies on the side its normal points to.
  Sensors(const Solver& solver, std::span<const scene::Sensor> sensors, Quantity quantity, int rays,
          std::uint64_t seed);

  [[nodiscard]] std::size_t size() const { return count_; }

  /// Direct light of one emitter at dimming 1 and white, lux per sensor.
  [[nodiscard]] std::vector<double> direct(const Solver& solver, const light::Emitter& emitter,
                                           std::span<const light::MaskBlocker> bodies) const;

  /// Direct light of the surroundings, the sun included, RGB lux per sensor; bodies as above. What
  /// the sensors see of the sky is looked at once: planar ones on 512 x 512 cells where an
  /// opening's edge is (OpenSky), others on 128 x 128 per orientation. Dark when cancelled.
  [[nodiscard]] std::vector<dvec3> outdoors(const Solver& solver,
                                            const daylight::Environment& environment,
                                            std::span<const light::MaskBlocker> bodies,
                                            const Job& job = {}) const;

  /// Indirect light from a radiosity per slot (Solver::indirect), RGB lux per sensor.
  [[nodiscard]] std::vector<dvec3> indirect(std::span<const vec4> source) const;

 private:
  /// Shared by copies.
  struct Sky {
    std::mutex mutex;
    std::optional<daylight::OpenSky> open;
  };
  std::shared_ptr<Sky> sky_ = std::make_shared<Sky>();
  std::size_t count_ = 0;
  std::size_t orientations_ = 1;  ///< planar readings per sensor
  light::Receivers receivers_;
  transfer::GatherLists lists_;
};

}  // namespace soffit::relight

// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/relight/sensors.h"

#include <list>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace soffit::relight {

/// Sensors read again and again while luminaires change: what one luminaire gives each sensor is
/// kept, so that a moved one costs its own light and a dimmed, coloured or switched one nothing.
///
/// The reading is Lighting::read()'s up to rounding: indirect light is gathered luminaire by
/// luminaire and then summed instead of the other way round. Not thread-safe.
class SensorReadings {
 public:
  /// sensors: world. rays, seed: as Sensors takes them.
  SensorReadings(std::vector<scene::Sensor> sensors, int rays, std::uint64_t seed);

  /// What the next read() computes with. The sensors' own rays are traced again only when the
  /// operators are others: new reflectances keep them.
  void setSolver(std::shared_ptr<const Solver> solver);

  /// Light of luminaires at the sensors and of what shines in from outside (null: nothing), in the
  /// sensors' order. Emitters are scene-local.
  /// Errors: no solver yet; cancelled (what was computed until then is kept).
  Result<std::vector<SensorLight>> read(
      std::span<const light::Emitter> emitters,
      const std::shared_ptr<const daylight::Environment>& outside = nullptr, const Job& job = {});

 private:
  /// One luminaire at gain 1 and white.
  struct Response {
    light::Emitter emitter;
    std::vector<double> direct;
    std::vector<dvec3> indirect;
  };
  const Response& responseTo(std::span<const light::Emitter> emitters, std::size_t i,
                             std::span<const float> open);
  Result<void> ensureOutside(const std::shared_ptr<const daylight::Environment>& outside,
                             std::span<const light::Emitter> emitters, std::span<const float> open,
                             const Job& job);
  void dropIfBodiesChanged(std::span<const light::Emitter> emitters);

  std::vector<scene::Sensor> points_;
  int rays_;
  std::uint64_t seed_;
  std::shared_ptr<const Solver> solver_;
  std::optional<Sensors> sensors_;
  std::shared_ptr<const daylight::Environment> outside_;  ///< that outdoors_ is the light of
  std::vector<SensorLight> outdoors_;                     ///< empty: not known
  std::list<Response> responses_;                         ///< the one used last in front
  std::vector<light::Emitter> bodies_;  ///< that the responses were computed among
};

}  // namespace soffit::relight

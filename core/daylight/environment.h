// SPDX-License-Identifier: MIT
#pragma once

#include "core/daylight/cie_sky.h"
#include "core/daylight/picture_light.h"
#include "core/daylight/sky_table.h"
#include "core/math/vec.h"
#include "core/scene/environment.h"
#include "core/sh/analytic_light.h"

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

/// The surroundings as radiance by direction (unit, from the receiver outwards, world axes).
namespace soffit::daylight {

/// The sun's disc, of even radiance.
struct Sun {
  static constexpr double kRadius = 0.5 * 0.533 * kPi / 180.0;  ///< rad
  dvec3 direction{0.0, 0.0, 1.0};
  double normal_illuminance = 0.0;  ///< lx on a plane that faces it
  /// cd/m^2: E = L pi sin^2 of the radius.
  [[nodiscard]] double radiance() const;
  [[nodiscard]] bool covers(const dvec3& d) const;
};

/// Immutable.
class Environment {
 public:
  /// like: surroundings whose picture is taken over where it is the same one, so that turning or
  /// scaling it costs nothing; may be null.
  explicit Environment(const scene::Environment& description, const Environment* like = nullptr);

  /// RGB, cd/m^2 (Y of linear Rec.709), all but the sun's disc. Pictures are bilinear.
  [[nodiscard]] dvec3 radiance(const dvec3& d) const;
  /// The same as far as receivers need it: pictures averaged over about a degree, spots left out.
  [[nodiscard]] dvec3 smoothRadiance(const dvec3& d) const;
  /// Discs that are too small and bright for smoothRadiance(): the sun and the spots of a picture.
  [[nodiscard]] const std::vector<Spot>& spots() const { return spots_; }
  [[nodiscard]] const std::optional<Sun>& sun() const { return sun_; }
  /// All channels are equal everywhere.
  [[nodiscard]] bool grey() const { return picture_ == nullptr; }
  /// Below the horizon it looks the same everywhere.
  [[nodiscard]] bool evenGround() const { return sky_.has_value(); }
  /// Directions drawn in proportion to luminance, for sampling radiance(). Made when first asked
  /// for.
  [[nodiscard]] const SkyTable& table() const;
  /// Whether it gives any light at all.
  [[nodiscard]] bool dark() const;

 private:
  struct Table {
    std::once_flag once;
    std::optional<SkyTable> table;
  };
  [[nodiscard]] dvec3 turned(const dvec3& d) const;
  [[nodiscard]] std::vector<double> tableWeights() const;

  std::optional<CieSky> sky_;
  double ground_ = 0.0;  ///< cd/m^2 below the horizon
  std::optional<Sun> sun_;
  std::shared_ptr<const PictureLight> picture_;
  std::optional<sh::AnalyticLight> patches_;
  double cos_turn_ = 1.0;  ///< of the rotation
  double sin_turn_ = 0.0;
  std::vector<Spot> spots_;
  std::shared_ptr<Table> table_ = std::make_shared<Table>();  ///< shared by copies
};

}  // namespace soffit::daylight

// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/scene/environment.h"
#include "core/sh/environment_layout.h"

#include <memory>
#include <vector>

namespace soffit::daylight {

/// A disc of light too small and bright for tables of directions.
struct Spot {
  dvec3 direction{0.0, 0.0, 1.0};
  double radius = 0.0;            ///< rad
  dvec3 normal_illuminance{0.0};  ///< RGB lx on a plane that faces it
};

/// A picture of the surroundings as light, in its own axes (the centre looks to +y).
class PictureLight {
 public:
  /// scale: cd/m^2 per unit. Negative pixels count as 0.
  PictureLight(std::shared_ptr<const scene::Image> image, scene::ProbeLayout layout, double scale);

  /// The same picture at another scale, which takes no look at its pixels.
  [[nodiscard]] PictureLight scaled(double scale) const;
  [[nodiscard]] bool isOf(const std::shared_ptr<const scene::Image>& image,
                          scene::ProbeLayout layout) const {
    return image_ == image && named_ == layout;
  }
  [[nodiscard]] double scale() const { return scale_; }

  /// Bilinear, RGB cd/m^2; squares of a cross are not mixed with their neighbours in the picture.
  [[nodiscard]] dvec3 radiance(const dvec3& d) const;
  /// Mean radiance of the cell of SkyTable that holds d, spots left out.
  [[nodiscard]] const dvec3& smooth(const dvec3& d) const;
  /// Where more than a hundred times the mean radiance comes from, at most 64 discs.
  [[nodiscard]] const std::vector<Spot>& spots() const { return spots_; }
  /// Whether no light comes from anywhere.
  [[nodiscard]] bool dark() const;
  /// Luminance per cell of SkyTable, spots included.
  [[nodiscard]] std::vector<double> weights() const;

 private:
  void findSpots(const scene::Image& image);
  [[nodiscard]] dvec3 lookUp(const scene::Image& image, const dvec3& d) const;
  [[nodiscard]] dvec3 pixel(const scene::Image& image, int x, int y) const;

  std::shared_ptr<const scene::Image> image_;
  scene::ProbeLayout named_ = scene::ProbeLayout::lat_long;
  sh::EnvironmentLayout layout_ = sh::EnvironmentLayout::lat_long;
  double scale_ = 1.0;
  std::vector<dvec3> cells_;
  std::vector<Spot> spots_;
  double spot_threshold_ = 0.0;  ///< cd/m^2
};

}  // namespace soffit::daylight

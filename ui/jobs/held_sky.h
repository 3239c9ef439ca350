// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/lighting.h"
#include "core/relight/sky_vectors.h"

#include <memory>
#include <vector>

namespace soffit::ui {

/// The light of one step of a slider of the surroundings at the points that a view shows, for the
/// view to add up: rest + vectors * weights (relight::SkyVectors).
struct HeldSky {
  std::shared_ptr<const relight::SkyVectors> vectors;
  std::vector<dvec3> weights;
  /// RGB lux per point; the same object for as long as it is the same light.
  std::shared_ptr<const std::vector<vec3>> rest;
};

/// Makes them. Belongs to one thread.
class HeldSkies {
 public:
  /// Whether step() can answer.
  [[nodiscard]] bool fits(const relight::SkyParts& parts,
                          const std::shared_ptr<const relight::LightRows>& points) const {
    return vectors_ != nullptr && vectors_->transfer() == parts.transfer &&
           vectors_->rows() == points;
  }
  /// Takes some tenths of a second. Cancelled: nothing fits.
  void prepare(const relight::SkyParts& parts, const transfer::Operators& operators,
               const std::shared_ptr<const relight::LightRows>& points, const Job& job);
  [[nodiscard]] std::shared_ptr<const HeldSky> step(const relight::SkyParts& parts);
  [[nodiscard]] bool empty() const { return vectors_ == nullptr; }
  /// What is there for other points goes.
  void keepFor(const std::shared_ptr<const relight::LightRows>& points) {
    if (vectors_ != nullptr && vectors_->rows() != points) forget();
  }
  void forget();

 private:
  std::shared_ptr<const relight::SkyVectors> vectors_;
  std::shared_ptr<const relight::Planes> rest_planes_;
  std::shared_ptr<const std::vector<vec3>> rest_;  ///< of those planes
};

}  // namespace soffit::ui

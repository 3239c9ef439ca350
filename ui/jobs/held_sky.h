// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/lighting.h"
#include "core/relight/sky_vectors.h"

#include <memory>
#include <vector>

namespace soffit::ui {

/// The light of one step of a slider of the surroundings, for a view to add up
/// (relight::SkyVectors).
struct HeldSky {
  std::shared_ptr<const relight::SkyVectors> vectors;
  std::vector<dvec3> weights;
  /// The same object for as long as it is the same light.
  std::shared_ptr<const relight::SkyRest> rest;
};

/// Makes them. Belongs to one thread.
class HeldSkies {
 public:
  [[nodiscard]] bool empty() const { return vectors_ == nullptr; }
  /// Whether step() can answer.
  [[nodiscard]] bool fits(const relight::SkyParts& parts) const {
    return vectors_ != nullptr && vectors_->transfer() == parts.transfer;
  }
  /// Takes some tenths of a second. Cancelled: nothing fits.
  void prepare(const relight::SkyParts& parts, const transfer::Operators& operators,
               const Job& job);
  [[nodiscard]] std::shared_ptr<const HeldSky> step(const relight::SkyParts& parts) const {
    return std::make_shared<const HeldSky>(HeldSky{vectors_, parts.weights, parts.rest});
  }
  void forget() { vectors_.reset(); }

 private:
  std::shared_ptr<const relight::SkyVectors> vectors_;
};

}  // namespace soffit::ui

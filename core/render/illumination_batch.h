// SPDX-License-Identifier: MIT
#pragma once

#include "core/render/illumination.h"

#include <cstdint>
#include <vector>

namespace soffit::render {

/// Collects surface points and has them lit in one go, sorted so that neighbours on a surface are
/// neighbours in the call. Keeps its memory between uses.
class IlluminationBatch {
 public:
  void clear();

  /// Points of one surface should be added in an order that is coherent in space.
  /// Returns the index for total().
  std::uint32_t add(const SurfacePoint& point, std::uint32_t surface);

  /// Asks for the light at all points since clear().
  void run(const Illumination& illumination);

  /// Direct + indirect illuminance, lux; what is not finite or negative counts as 0.
  [[nodiscard]] const vec3& total(std::uint32_t index) const { return totals_[index]; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }

 private:
  std::vector<SurfacePoint> points_;
  std::vector<std::uint64_t> order_;  // surface, then index
  std::vector<SurfacePoint> sorted_;
  std::vector<vec3> direct_;
  std::vector<vec3> indirect_;
  std::vector<vec3> totals_;
};

}  // namespace soffit::render

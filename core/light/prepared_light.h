// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/emitter.h"
#include "core/light/light_mask.h"

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace soffit::light {

/// What a light needs to be evaluated at many points: its bit images at several subdivisions, its
/// points, its closed form. Made once per position; cheap (some 10 microseconds for a panel).
class PreparedLight {
 public:
  /// How visibility is measured.
  enum class Form {
    planar,  ///< bit image of a planar outline
    facing,  ///< sphere or tube: a bit image that faces each group of receivers
    points,  ///< points on the surface
  };
  static constexpr int kLevels = 4;
  static constexpr int kSampleLevels = 5;  ///< 1, 4, 16, 64, 256 points

  explicit PreparedLight(const Emitter& emitter);

  [[nodiscard]] const Emitter& emitter() const { return emitter_; }
  [[nodiscard]] Form form() const { return form_; }

  /// Bit images that cover the planar light, level 0 whole, each further level halves the cells.
  /// Made when first asked for; any thread may ask.
  [[nodiscard]] std::span<const MaskLight> masks(int level) const;
  /// The level at which cells are at most half as large as `distance` (m), or the finest.
  [[nodiscard]] int maskLevel(float distance) const;

  /// Points for quadrature, 4^level of them (1 for point sources at any level); weights sum to
  /// the area (1 for point sources).
  [[nodiscard]] const PointLightSamples& samples(int level) const { return samples_[static_cast<std::size_t>(level)]; }
  /// The level whose quadrature error is about 1e-3 at this distance (m).
  [[nodiscard]] int sampleLevel(float distance) const;

  /// Sphere or tube: the bit image of its outline as seen from `eye`, and the plane that holds it.
  [[nodiscard]] MaskLight facing(const vec3& eye) const;

  /// Unoccluded illuminance for the 16 receivers at `distance` (m, least distance of the group to
  /// the light), lux at dimming 1.
  void unoccluded(const MaskReceivers& receivers, float distance, double* lux) const;

 private:
  /// Made on demand; shared by copies.
  struct Masks {
    std::array<std::once_flag, kLevels> once;
    std::array<std::vector<MaskLight>, kLevels> levels;
  };
  void makeMasks(int level) const;
  void prepareSamples();
  void prepareFacets();
  /// E/L of the first `count` facets: as triangles where they are near, else as points.
  [[nodiscard]] double nearFacets(std::size_t count, const dvec3& p, const dvec3& n) const;

  Emitter emitter_;
  Form form_ = Form::points;
  std::shared_ptr<Masks> masks_ = std::make_shared<Masks>();
  float cell_diagonal_ = 0.0F;  ///< of level 0
  std::array<PointLightSamples, kSampleLevels> samples_;
  /// A large mesh's triangles as points at their centroids, the largest first.
  struct Facets {
    std::vector<std::uint32_t> order;  ///< triangles
    std::vector<float> extent;         ///< m, in that order
    PointLightSamples points;          ///< in that order
  };
  Facets facets_;
  bool exact_ = false;  ///< a closed form exists and is used
};

/// Unoccluded illuminance of any emitter at a point, lux at dimming 1: the closed form, or
/// quadrature refined until it agrees to 1e-6 for measured photometry and large meshes.
double unoccludedIlluminance(const Emitter& emitter, const dvec3& p, const dvec3& n);

}  // namespace soffit::light

// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// Visibility of area lights in light space: the light is a bit image, every blocker clears the
/// bits it hides, for 16 receivers at once (Highway: SSE2 to AVX-512 chosen at run time).
/// design.md section 3, steps 4 and 5.
namespace soffit::light {

/// A parallelogram origin + a u + b v, a and b in [0,1], sampled by 16 slanted rows of 32 bits:
/// bit i of row j stands at a = (i + o_j)/32, b = (j + a)/16, o_j the van der Corput numbers.
/// Slanted rows keep axis-parallel edges from aliasing with the rows.
struct MaskLight {
  static constexpr int kRows = 16;
  static constexpr int kColumns = 32;
  static constexpr int kCells = 16;  ///< 4 x 4 cells of 4 rows x 8 columns carry the weights

  vec3 origin{0.0F}, u{1.0F, 0.0F, 0.0F}, v{0.0F, 1.0F, 0.0F};
  vec3 normal{0.0F, 0.0F, -1.0F};       ///< emission side, unit
  bool lambertian = true;               ///< weights carry the cosine at the light
  std::array<std::uint32_t, kRows> outline{};  ///< bits inside the light's outline
  std::array<vec3, kCells> cell_center{};
  std::array<float, kCells> cell_count{};      ///< outline bits per cell

  /// The place of bit i in row j.
  [[nodiscard]] vec3 sample(int row, int column) const;
  /// Sets cell_center and cell_count from the rest.
  void finish();
  /// Offset o_j of row j, in [0, 1): centred van der Corput numbers, (bit-reversed j + 1/2)/16.
  static constexpr float rowOffset(int row) {
    const int reversed = (row & 1) << 3 | (row & 2) << 1 | (row & 4) >> 1 | (row & 8) >> 3;
    return (static_cast<float>(reversed) + 0.5F) / kRows;
  }
};

/// `unit`, a finished light on the square (0,0,0), (1,0,0), (0,1,0), laid over another
/// parallelogram: its outline and cells without visiting their bits again.
MaskLight placed(const MaskLight& unit, const vec3& origin, const vec3& u, const vec3& v,
                 const vec3& normal);

/// A parallelogram light without outline (all bits set), finished.
MaskLight makeMaskLight(const vec3& origin, const vec3& u, const vec3& v, const vec3& normal, bool lambertian);

/// A blocker as the kernels take it: convex, planar, 3 to 5 corners, counter-clockwise seen from
/// its front (n.x > d).
struct MaskBlocker {
  std::array<vec3, 5> corners{};
  int count = 3;
  vec3 normal{0.0F};
  float d = 0.0F;
  bool solid = false;  ///< hides only what lies behind its front
};

class BlockerLanes;

/// 16 receivers, structure of arrays.
struct MaskReceivers {
  const float *x, *y, *z, *nx, *ny, *nz;
  std::uint32_t lanes = 0xffffU;  ///< bit per receiver: those whose visibility is asked for
};

/// Sums over the light for 16 receivers: visible and whole weight. V = visible / total; when
/// total is 0 (no weight, yet light by the closed form) use plain_visible / plain_total.
struct MaskSums {
  alignas(64) std::array<float, 16> visible{};
  alignas(64) std::array<float, 16> total{};
  alignas(64) std::array<float, 16> plain_visible{};
  alignas(64) std::array<float, 16> plain_total{};
};

/// The shadow that blockers cast on 16 receivers, as bits of a parallelogram light.
class MaskShadow {
 public:
  /// Refers to both; they must outlive it. Receivers not in `lanes` are left out.
  MaskShadow(const MaskLight& light, const MaskReceivers& receivers);

  /// Hides what lies behind the blockers; returns whether nothing of the light is seen any more.
  /// epsilon (m): receivers nearer than this to a blocker's plane are not hidden by it. Blockers
  /// must be clipped to the light's front. Their order does not matter.
  bool hide(const BlockerLanes& blockers, float epsilon);

  /// Adds the light's weights to `sums`.
  void addTo(MaskSums& sums) const;

  /// For the kernels: hidden bits by receiver and row, and the receivers that see some light yet.
  struct State {
    alignas(64) std::uint32_t hidden[16][MaskLight::kRows];
    std::uint32_t open;
  };

 private:
  const MaskLight& light_;
  const MaskReceivers& receivers_;
  State state_;
};

/// A light as points on its surface: any shape. weight: m^2 (or any measure); normal (0,0,0) where
/// the emission has no cosine (measured photometry, point sources).
struct PointLightSamples {
  std::vector<float> x, y, z, nx, ny, nz, weight;
  [[nodiscard]] std::size_t size() const { return x.size(); }
};

/// The same sums for a light made of points; blockers beyond a point, or within epsilon in front
/// of it, do not hide it. Runs of 16 points that lie together make it quick (orderByPlace).
void addPointVisibility(const PointLightSamples& points, const BlockerLanes& blockers,
                        const MaskReceivers& receivers, float epsilon, MaskSums& sums);

/// E/L under facets [first, end) that each are as good as a point, all of them with a normal, for
/// 16 receivers; in float: some 1e-6 of the sum.
void facetIrradiance16(const PointLightSamples& facets, std::size_t first,
                       const MaskReceivers& receivers, float* value);

/// Closed-form E/L of a planar polygon (relative orientation as in polygonIrradiance) for 16
/// receivers in double precision; `clipped` gets a bit per receiver whose horizon cuts the
/// polygon: those values are not valid and are left to polygonIrradiance().
void contourIrradiance16(std::span<const dvec3> outline, const MaskReceivers& receivers, double* value,
                         std::uint32_t& clipped);

/// The same of a disk (as in diskIrradiance).
void diskIrradiance16(const dvec3& center, const dvec3& axis, double radius,
                      const MaskReceivers& receivers, double* value, std::uint32_t& clipped);

/// The instruction set in use, for reports.
const char* simdTargetName();

}  // namespace soffit::light

// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Where transfer is wanted: one abstraction for vertices of a mesh and texels of transfer
/// textures.
namespace soffit::prt {

inline constexpr std::uint32_t kNoReceiver = 0xffffffffU;

/// Points that receive light, scene-local frame; one element of every list per receiver.
struct Receivers {
  std::vector<vec3> positions;
  std::vector<vec3> normals;      ///< shading, unit: the cosine is to this
  std::vector<vec3> facing;       ///< geometric, unit, on the receiving side: the horizon, offsets
  std::vector<vec3> reflectance;  ///< diffuse, linear Rec.709, 0..1
  std::vector<float> areas;       ///< of the surface that it stands for, m^2; they sum to all of it
  /// Whose transfer it takes: itself, or, where it lies inside other matter, the nearest that does
  /// not. Empty: all their own.
  std::vector<std::uint32_t> source;

  [[nodiscard]] std::size_t size() const { return positions.size(); }
  [[nodiscard]] std::uint32_t sourceOf(std::size_t i) const {
    return source.empty() ? static_cast<std::uint32_t>(i) : source[i];
  }
  [[nodiscard]] bool standsForItself(std::size_t i) const { return sourceOf(i) == i; }
  /// Whether all reflectances are grey: bounced light then needs one channel instead of three.
  [[nodiscard]] bool grey() const;
};

/// A receiver and its share in something interpolated.
struct Tap {
  std::uint32_t receiver = 0;
  float weight = 0.0F;
};

/// Receivers that cover surfaces: what a ray meets is interpolated from those around its hit.
class ReceiverSet {
 public:
  virtual ~ReceiverSet() = default;

  static constexpr std::size_t kMostAround = 4;
  using Around = std::array<Tap, kMostAround>;

  [[nodiscard]] const Receivers& receivers() const { return receivers_; }

  /// Receivers around a hit of the surfaces' caster on one side, with weights that sum to 1; their
  /// number, 0 where that side receives nothing.
  [[nodiscard]] virtual std::size_t around(const geometry::Hit& hit, bool front,
                                           Around& taps) const = 0;

  /// For each receiver the nearest valid one along the surface (in steps from neighbor to
  /// neighbor), itself when it is valid or none can be reached. valid: 0 or 1 per receiver.
  [[nodiscard]] virtual std::vector<std::uint32_t> nearestValid(
      std::span<const std::uint8_t> valid) const = 0;

  /// Lets every receiver that is not valid take the transfer of nearestValid().
  void replaceInvalid(std::span<const std::uint8_t> valid) {
    receivers_.source = nearestValid(valid);
  }

 protected:
  Receivers receivers_;
};

/// Spreads outward from the valid ones, ring by ring: in compressed rows, the neighbors of i are
/// neighbors[offsets[i]] .. neighbors[offsets[i + 1] - 1].
std::vector<std::uint32_t> spreadFromValid(std::span<const std::uint8_t> valid,
                                           std::span<const std::uint32_t> offsets,
                                           std::span<const std::uint32_t> neighbors);

}  // namespace soffit::prt

// SPDX-License-Identifier: MIT
#pragma once

#include "core/prt/receivers.h"
#include "core/prt/surfaces.h"
#include "core/prt/texel_raster.h"
#include "core/prt/texture_layout.h"
#include "core/prt/texture_level.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace soffit::prt {

/// The transfer texture of one object.
struct TextureSet {
  std::string name;  ///< of the object
  TextureLayout layout;
  std::vector<TextureLevel> levels;  ///< finest first; item k of levels[0] is receiver first + k
  std::uint32_t first = 0;           ///< receiver
  std::uint32_t count = 0;
};

/// The texels of transfer textures as receivers (Dhawal et al. 2022), a set per object: a wall of
/// two triangles gets its shadows, whatever the tessellation.
///
/// Shading normals take the materials' normal maps, reflectances their diffuse maps, averaged over
/// the texel. Errors: light is interpolated between texels' centers; on texels that a chart's edge
/// cuts it is that of a point up to half a texel away.
class TextureReceivers final : public ReceiverSet {
 public:
  /// set_of: per triangle, the number of its set; names: one per set. A texture each. A cancelled
  /// job leaves receivers out.
  TextureReceivers(std::shared_ptr<const Surfaces> surfaces, std::vector<std::uint32_t> set_of,
                   const std::vector<std::string>& names, const TextureOptions& options,
                   const Job& job = {});
  /// A set for each of the mesh's objects.
  static TextureReceivers perObject(std::shared_ptr<const Surfaces> surfaces,
                                    const TextureOptions& options, const Job& job = {});
  /// One texture for everything (an atlas).
  static TextureReceivers atlas(std::shared_ptr<const Surfaces> surfaces,
                                const TextureOptions& options, const Job& job = {});

  [[nodiscard]] const std::vector<TextureSet>& sets() const { return sets_; }
  [[nodiscard]] const Surfaces& surfaces() const { return *surfaces_; }
  [[nodiscard]] std::uint32_t setOf(std::uint32_t triangle) const { return set_of_[triangle]; }

  /// Place of a hit in its set's finest texture, in texels; false where that side receives nothing.
  bool place(const geometry::Hit& hit, bool front, vec2& out) const;

  std::size_t around(const geometry::Hit& hit, bool front, Around& taps) const override;
  std::vector<std::uint32_t> nearestValid(std::span<const std::uint8_t> valid) const override;

 private:
  void addSet(const std::string& name, const std::vector<std::uint32_t>& triangles,
              const TextureOptions& options, const Job& job);
  void addReceiver(const RasterTexel& texel, double width);
  [[nodiscard]] bool find(const geometry::Hit& hit, bool front, vec2& place,
                          std::uint32_t& chart) const;

  std::shared_ptr<const Surfaces> surfaces_;
  std::vector<std::uint32_t> set_of_;  ///< per triangle
  std::vector<std::uint32_t> local_;   ///< per triangle, into its layout; kNoReceiver without
  std::vector<TextureSet> sets_;
  std::vector<std::uint32_t> chart_of_;  ///< per receiver, in its set
};

}  // namespace soffit::prt

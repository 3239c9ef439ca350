// SPDX-License-Identifier: MIT
#pragma once

#include "core/daylight/panes.h"
#include "core/geometry/ray_caster.h"
#include "core/math/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// The look of one receiver at its hemisphere (internal to OpenSky, open_sky.h).
namespace soffit::daylight {

struct LookOptions;

/// A pane that the first look might miss.
struct PaneSeed {
  vec3 center{0.0F};
  vec3 normal{0.0F};
  float area = 0.0F;
};
/// Of every glass triangle, at most 128.
std::vector<PaneSeed> paneSeeds(const Panes* panes);

/// The place of a direction in the unit square of the cosine-weighted hemisphere about +z, the
/// inverse of cosineHemisphere(). d.z >= 0.
vec2 hemispherePlace(const vec3& d);

class HemisphereCells {
 public:
  HemisphereCells(const geometry::RayCaster& opaque, const Panes* panes,
                  const LookOptions& options);

  void look(const vec3& p, const vec3& n, std::span<const PaneSeed> seeds, std::uint64_t seed);

  /// visit(level, column, row, share) for what the last look() left open.
  template <class Visit>
  void forEachOpenLeaf(const Visit& visit) const {
    for (int level = 0; level <= reached_; ++level) {
      const Grid& g = grids_[static_cast<std::size_t>(level)];
      for (std::size_t k = 0; k < g.traced.size(); ++k) {
        const std::uint32_t cell = g.traced[k];
        const bool parent = level < reached_ && g.cut[cell] != 0;
        if (parent || g.share[k] <= 0.0F) continue;
        const auto side = static_cast<std::uint32_t>(g.side);
        visit(level, static_cast<int>(cell % side), static_cast<int>(cell / side), g.share[k]);
      }
    }
  }

  [[nodiscard]] std::uint64_t takeRays() {
    const std::uint64_t rays = rays_;
    rays_ = 0;
    return rays;
  }

 private:
  static constexpr int kMostLevels = 5;
  struct Grid {
    int side = 0;
    std::vector<std::uint8_t> open;     ///< per cell; from the coarser level where not traced
    std::vector<std::uint8_t> cut;      ///< per cell: traced here and refined
    std::vector<std::uint8_t> own;      ///< per cell: traced
    std::vector<std::uint32_t> traced;  ///< cells with a ray of their own
    std::vector<float> share;           ///< per traced cell
  };
  void findWanted(const vec3& p, const vec3& n, std::span<const PaneSeed> seeds);
  /// The cells of `traced` from `first` on.
  void trace(Grid& grid, std::size_t first, const vec3& p, const vec3& n, std::uint64_t seed);
  /// Marks the cells to cut; returns whether there are any.
  bool chooseCuts(Grid& grid) const;
  void refine(const Grid& from, Grid& to) const;
  /// Cuts the cells that an opening runs on into from finer cells beside them; whether there are
  /// any.
  bool spread(Grid& from, Grid& to) const;
  static void addChildren(const Grid& from, std::uint32_t cell, Grid& to);

  const geometry::RayCaster& opaque_;
  const Panes* panes_;
  int levels_;
  int reached_ = 0;
  std::array<Grid, kMostLevels> grids_;
  std::vector<vec2> wanted_;  ///< places in the square that are looked at closely
  std::vector<geometry::Ray> rays_of_;
  std::vector<std::uint8_t> blocked_;
  std::uint64_t rays_ = 0;
};

}  // namespace soffit::daylight

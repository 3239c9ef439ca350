// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/daylight/environment.h"
#include "core/daylight/panes.h"
#include "core/daylight/square_directions.h"
#include "core/geometry/ray_caster.h"
#include "core/math/sampling.h"
#include "core/math/vec.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace soffit::daylight {

/// How closely receivers look for the sky.
struct LookOptions {
  int coarse = 16;         ///< cells per side of the first look, a multiple of 4, at most 64
  int levels = 3;          ///< how often cells on the edge of an opening are halved, at most 4
  std::uint64_t seed = 1;  ///< of the jitter
};

/// What each of many receivers sees of the surroundings, and through how much glass: geometry
/// alone, so that any sky and any turn of it is evaluated without a ray.
///
/// The hemisphere is the unit square by Shirley & Chiu's map with the cosine in it: cells of equal
/// weight. Each gets one jittered ray; cells whose neighbours disagree, and those in which a pane
/// stands, are cut in four again and again. A cell is a leaf: open to a share of light, or closed.
/// The edge of an opening of perimeter P (in the square) crosses P N cells of the finest side N =
/// coarse 2^levels, each of which errs by chance: standard error sqrt(P N) / (2 N^2) of the square.
/// For a window that fills 2 % of it (P = 0.56) 1.3 % of its light at N = 128 and 0.16 % at 512.
/// Openings without glass below 1 / coarse^2 of the square may be missed by the first look.
/// Luminaires' bodies are not seen. 4 bytes per leaf.
class OpenSky {
 public:
  OpenSky() = default;
  /// positions, normals: scene-local, normals unit; a zero normal sees nothing. panes may be null.
  /// A cancelled job leaves the rest without sky.
  OpenSky(std::span<const vec3> positions, std::span<const vec3> normals,
          const geometry::RayCaster& opaque, const Panes* panes, const LookOptions& options,
          const Job& job = {});

  [[nodiscard]] std::size_t size() const { return normals_.size(); }
  [[nodiscard]] std::size_t bytes() const {
    return (look_.leaves.size() + look_.first.size()) * sizeof(std::uint32_t) +
           normals_.size() * sizeof(vec3);
  }

  /// What was found, for keeping.
  struct Look {
    int coarse = 16;
    std::vector<std::uint32_t> first;   ///< per receiver, into leaves; one more at the end
    std::vector<std::uint32_t> leaves;  ///< column 9 bits, row 9, level 3, share 11
  };
  [[nodiscard]] const Look& found() const { return look_; }
  [[nodiscard]] std::span<const vec3> normals() const { return normals_; }
  /// A look that was kept, of receivers with these normals; nothing when it does not fit them.
  static std::optional<OpenSky> restored(std::span<const vec3> normals, Look look);

  /// Rays traced.
  [[nodiscard]] std::uint64_t rays() const { return rays_; }
  /// Whether any receiver sees anything of the outside.
  [[nodiscard]] bool any() const { return !look_.leaves.empty(); }

  /// RGB lux of smoothRadiance() per receiver. A cancelled job leaves the rest dark.
  [[nodiscard]] std::vector<vec3> illuminance(const Environment& environment,
                                              const Job& job = {}) const;

  /// visit(direction, weight) for every open leaf of a receiver, cut so that about `steps` of its
  /// pieces lie along the square's side (a power of 2): the sum of weight times radiance is the
  /// illuminance. Toward the receiver's horizon equal steps of the square are ever larger angles
  /// (the last of 64 spans ten degrees): there they are a quarter as long.
  template <class Visit>
  void forEachDirection(std::size_t receiver, int steps, const Visit& visit) const {
    vec3 t(0.0F);
    vec3 b(0.0F);
    const vec3& n = normals_[receiver];
    orthonormalBasis(n, t, b);
    for (std::uint32_t k = look_.first[receiver]; k < look_.first[receiver + 1]; ++k) {
      const Leaf leaf = unpack(look_.leaves[k]);
      int cuts = std::max(1, static_cast<int>(leaf.size * static_cast<float>(steps)));
      const vec2 off = glm::abs(vec2(2.0F * leaf.x - 1.0F, 2.0F * leaf.y - 1.0F) + leaf.size);
      if (std::max(off.x, off.y) + leaf.size > 0.999F) cuts *= 4;
      const int side = static_cast<int>(std::lround(1.0F / leaf.size)) * cuts;
      const auto column = static_cast<int>(std::lround(leaf.x * static_cast<float>(side)));
      const auto row = static_cast<int>(std::lround(leaf.y * static_cast<float>(side)));
      const float weight = leaf.weight / static_cast<float>(cuts * cuts);
      const SquareDirections directions(side);
      for (int j = 0; j < cuts; ++j) {
        for (int i = 0; i < cuts; ++i) {
          const vec3 d = directions.at(column + i, row + j);
          visit(d.x * t + d.y * b + d.z * n, weight);
        }
      }
    }
  }

 private:
  struct Leaf {
    float x, y, size;  ///< of the cell in the unit square
    float weight;      ///< pi area times the share of light
  };
  [[nodiscard]] Leaf unpack(std::uint32_t leaf) const;

  std::vector<vec3> normals_;
  Look look_;
  std::uint64_t rays_ = 0;
};

}  // namespace soffit::daylight

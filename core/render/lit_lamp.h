// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/glossy/parallax.h"
#include "core/light/emitter.h"

#include <memory>
#include <span>
#include <vector>

/// Luminaires for reflections that follow a drag: each as a few small round ones, with a cube map
/// round it of how far its light goes and how much there is.
namespace soffit::render {

/// What leaves a place by direction: 1/z of the first surface (glossy::ProbeDepth) and candela at
/// dimming 1 and a colour of Y = 1.
class LampMap {
 public:
  static constexpr int kSide = 64;
  LampMap(const geometry::RayCaster& caster, const light::Emitter& emitter, const vec3& from);

  struct Seen {
    float distance = 0.0F;  ///< m, infinite where nothing is
    float candela = 0.0F;
  };
  /// direction: any length above 0. Bilinear between texels of a face.
  [[nodiscard]] Seen toward(const vec3& direction) const;
  /// [face][row][column], kSide + 2 rows and columns each: (1/z in 1/m, candela).
  [[nodiscard]] std::span<const vec2> rimmed() const { return texels_; }

 private:
  std::vector<vec2> texels_;
};

/// A piece of a luminaire.
struct LitLamp {
  vec3 position{0.0F};
  float radius = 0.0F;  ///< m, of a disc as large as the piece looks; 0: a point
  vec3 color{0.0F};     ///< linear Rec.709 with dimming and the piece's share of the luminaire
  std::shared_ptr<const LampMap> map;

  /// Of 1 m and the distance: so far behind what the lamp sees a point is still lit, or dark.
  static constexpr float kSeen = 0.01F;
  static constexpr float kHidden = 0.03F;
  /// alpha^2 of a lobe grows by this times the square of the lamp's radius over its distance: the
  /// half vector turns by half the angle, and a disc's mean square radius is half its radius's
  /// square, which makes 1/8; the tails of GGX want more. Found against linearly transformed
  /// cosines (tests).
  static constexpr float kSpread = 0.2F;
};

/// What a lobe reflects of a lamp: I / r^2 where the lamp's map sees the point, times the lobe in
/// the lamp's direction, made wider by the lamp's size (LitLamp::kSpread), cd/m2.
/// All unit vectors; position, normal, to_eye as ReflectingPoint has them.
vec3 lampHighlight(const LitLamp& lamp, const vec3& position, const vec3& normal,
                   const vec3& to_eye, float f0, float alpha);

/// Makes the lamps of luminaires; what did not change since the last call is kept. Long ones are up
/// to four pieces in a row while there are few luminaires. Belongs to one thread.
class LampMaker {
 public:
  static constexpr std::size_t kMostLamps = 64;
  static constexpr std::size_t kFewLuminaires = 16;

  /// Those that are off are left out, and of very many those that give least to the places
  /// `before` (none: all are alike). emitters, caster, before: scene-local.
  std::vector<LitLamp> lampsOf(std::span<const light::Emitter> emitters,
                               const geometry::RayCaster& caster, std::span<const vec3> before);

 private:
  struct Known {
    light::Emitter emitter;
    int pieces = 0;              ///< at most
    std::vector<LitLamp> lamps;  ///< colours left out
  };
  std::vector<Known> known_;
};

}  // namespace soffit::render

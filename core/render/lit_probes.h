// SPDX-License-Identifier: MIT
#pragma once

#include "core/glossy/parallax.h"
#include "core/glossy/probe_sight.h"
#include "core/glossy/reflection_map.h"
#include "core/math/box.h"
#include "core/math/vec.h"
#include "core/render/lit_lamp.h"

#include <memory>
#include <span>
#include <vector>

namespace soffit::render {

/// A cube map of the lit scene, blurred for every roughness, and how far what it shows is away.
struct LitProbe {
  vec3 position{0.0F};
  std::shared_ptr<const glossy::ProbeDepth> depth;  ///< of what never moves
  std::shared_ptr<const glossy::ProbeSight> sight;
  glossy::ReflectionMap map;
};

/// A place that reflects, as it is shaded; all unit vectors.
struct ReflectingPoint {
  vec3 position{0.0F};
  vec3 normal{0.0F, 0.0F, 1.0F};  ///< shading normal, on the side of the eye
  vec3 to_eye{0.0F, 0.0F, 1.0F};
};

/// Reflections looked up in the probes' maps where the reflected ray meets what the probes see.
/// Immutable. ui/viewport/reflection_shader.h is the same for a graphics card, formula by formula:
/// who changes one changes the other (tests/ui/viewport compares pictures).
class LitProbes {
 public:
  /// Probes that take part at a point.
  static constexpr std::size_t kMostAtOnce = 3;
  /// Of the weight of the next one after those that take part, which is taken from theirs, so that
  /// probes come and go without a step.
  static constexpr float kNextShare = 0.99F;
  /// m^2, added to squared distances: two probes at a point share evenly.
  static constexpr float kNear = 0.01F;
  /// Least cosine between shading normal and eye (sampleSurface()'s).
  static constexpr float kLeastCosine = 0.02F;

  /// room: the box that reflections are corrected to where no probe sees the place. All in one
  /// frame.
  LitProbes(const Box& room, std::vector<LitProbe> probes, std::vector<LitLamp> lamps = {})
      : room_(room), probes_(std::move(probes)), lamps_(std::move(lamps)) {}

  [[nodiscard]] const Box& room() const { return room_; }
  [[nodiscard]] std::span<const LitProbe> probes() const { return probes_; }
  [[nodiscard]] std::span<const LitLamp> lamps() const { return lamps_; }

  /// What the specular lobe of a material (f0, alpha) reflects toward the eye, cd/m2. Up to
  /// kMostAtOnce probes that see the point take part, by 1 / distance^2, faded in over the border
  /// of what they see; the nearest one where none does. Both parts of the lobe
  /// (core/glossy/lobe_shape.h) are taken to end as far away as the ray along their weighted mean
  /// axis. Highlights of
  /// the lamps are added (lampHighlight()).
  [[nodiscard]] vec3 reflected(const ReflectingPoint& at, float f0, float alpha) const;

 private:
  [[nodiscard]] vec3 surfaces(const ReflectingPoint& at, float f0, float alpha) const;

  Box room_;
  std::vector<LitProbe> probes_;
  std::vector<LitLamp> lamps_;
};

}  // namespace soffit::render

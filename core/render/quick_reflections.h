// SPDX-License-Identifier: MIT
#pragma once

#include "core/render/illumination.h"
#include "core/render/probe_reflections.h"
#include "core/render/reflector.h"
#include "core/render/render_options.h"
#include "core/render/sent_albedo.h"
#include "core/render/specular_layer.h"
#include "core/render/view_scene.h"
#include "core/sh/sphere_samples.h"

#include <memory>
#include <optional>
#include <span>

namespace soffit::render {

/// The way that a picture's rough reflections come about: `automatic` settled. Final pictures trace
/// rays; quick ones take harmonics.
Reflections settled(Reflections wanted, bool quick);

/// Reflections of a picture's pixels without a ray per lobe: cube maps at probes, or harmonics
/// where five bands serve the lobe (glossy::leastAlphaFor()) and maps for sharper ones; highlights
/// of luminaires in closed form. Each pixel is seen as its first sample sees it. Harmonics gather
/// at one receiver for pixels of one surface in a block of 8 x 8.
class QuickReflections {
 public:
  /// Makes and lights the probes: a room's worth at about 2 m. scene, illumination outlive this.
  QuickReflections(const ViewScene& scene, const Illumination& illumination, Reflections method);

  /// Writes the layer's pixels, which need no smoothing. Mirrors (alpha < kMirrorAlpha) are left to
  /// rays by any method.
  void render(std::span<const ReflectingPixel> pixels, SpecularLayer& layer) const;

 private:
  void addHarmonics(std::span<const ReflectingPixel> pixels, std::vector<vec3>& radiance) const;

  const ViewScene& scene_;
  const Illumination& illumination_;
  SentAlbedo sent_;
  float least_alpha_;  ///< from which harmonics serve
  std::shared_ptr<const sh::SphereSamples> directions_;
  std::optional<ProbeReflections> maps_;
};

}  // namespace soffit::render

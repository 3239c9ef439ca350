// SPDX-License-Identifier: MIT
#pragma once

#include "core/render/illumination.h"
#include "core/render/lit_probes.h"
#include "core/render/surface_sample.h"
#include "core/render/view_scene.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace soffit::render {

/// Reflections without rays: cube maps of the lit room at probes, blurred by roughness and looked
/// up where the reflected ray meets what the probes see (core/glossy).
///
/// What probes see first is found once; a light that moves needs the light at those places anew and
/// no ray. Maps show surfaces as SentAlbedo has them, and no luminaires, whose highlights are added
/// for each point (lamp_highlights.h).
class ProbeReflections {
 public:
  /// probes: in the scene's frame, not in walls. room: the box that reflections are
  /// corrected to where no probe sees the place.
  ProbeReflections(const ViewScene& scene, std::span<const vec3> probes, const Box& room,
                   std::shared_ptr<const glossy::ReflectionLevels> levels);

  /// Renders the maps anew: the light at the cached places, then the blur.
  void light(const Illumination& illumination);

  [[nodiscard]] std::size_t probeCount() const { return probes_.size(); }
  /// Places whose light a move asks for.
  [[nodiscard]] std::size_t placeCount() const;

  /// What the specular lobe of a material (f0, alpha) reflects of surfaces toward the eye, cd/m2
  /// (LitProbes::reflected()). 0 before light() and without probes.
  [[nodiscard]] vec3 reflected(const SurfaceSample& at, float f0, float alpha) const;

 private:
  struct Probe {
    vec3 position{0.0F};
    std::shared_ptr<const glossy::ProbeDepth> depth;
    std::shared_ptr<const glossy::ProbeSight> sight;
    std::vector<SurfacePoint> places;
    std::vector<vec3> albedo;
    std::vector<std::uint32_t> texel;  ///< of each place
  };
  Box room_;
  std::shared_ptr<const glossy::ReflectionLevels> levels_;
  std::vector<Probe> probes_;
  std::optional<LitProbes> lit_;
};

/// Places for probes in a room: a grid of about `spacing` metres, at a third and at two thirds of
/// the height of `room`, without those nearer than 0.2 m to a surface.
std::vector<vec3> probeGrid(const ViewScene& scene, const Box& room, float spacing);

}  // namespace soffit::render

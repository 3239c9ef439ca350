// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/daylight/environment.h"
#include "core/glossy/reflection_map.h"
#include "core/relight/column.h"
#include "core/render/lit_probes.h"
#include "core/render/view_scene.h"
#include "core/transfer/texels.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace soffit::render {

class SentAlbedo;

/// Reflections that follow a drag: cube maps at a few probes before what reflects. What the probes
/// see is found once, with the texels whose light it shows; a new light is then a sum over texels
/// per map texel and the blur, without a ray. Luminaires stand beside the maps (lit_lamp.h).
///
/// Against final pictures (view_renderer.h) it simplifies: reflected surfaces show the light of
/// texels as wide as they are, all of it as if reflected diffusely (SentAlbedo); luminaires are
/// round pieces; normal maps are left out. Error: README.md.
class LiveProbes {
 public:
  static constexpr std::size_t kMostProbes = 10;
  /// Side of the maps of distances: edges of what is reflected are as fine.
  static constexpr int kDepthSide = 128;

  /// Null where no material has a lobe or no lit surface has such a material, and when cancelled.
  /// scene: for its surfaces; texels: whose light will be shown. Neither need outlive this.
  static std::shared_ptr<const LiveProbes> make(const ViewScene& scene,
                                                const transfer::Texels& texels, const Job& job);

  /// lux: RGB per slot of the texels. outside: what is seen where nothing is; null: black.
  [[nodiscard]] std::shared_ptr<const LitProbes> light(const relight::Planes& lux,
                                                       std::vector<LitLamp> lamps,
                                                       const daylight::Environment* outside) const;

  /// Where the probes are.
  [[nodiscard]] std::vector<vec3> places() const;
  /// Side of the maps: texels of half the width of the sharpest lobe of the scene, 16 to 64.
  [[nodiscard]] int side() const { return levels_->pyramid().side(); }
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Probe {
    vec3 position{0.0F};
    std::shared_ptr<const glossy::ProbeDepth> depth;  ///< of what never moves
    std::shared_ptr<const glossy::ProbeSight> sight;
    std::vector<vec3> albedo;                         ///< per map texel; negative: nothing is there
    std::vector<std::uint32_t> first;                 ///< per map texel and one past the last, into
    std::vector<std::uint32_t> slots;
    std::vector<float> weights;
  };
  LiveProbes() = default;
  static Probe look(const ViewScene& scene, const SentAlbedo& albedo,
                    const transfer::Texels& texels, const vec3& position,
                    const sh::SphereSamples& directions, int side);
  [[nodiscard]] LitProbe lit(const Probe& probe, const relight::Planes& lux,
                             const daylight::Environment* outside) const;

  Box room_;
  std::shared_ptr<const glossy::ReflectionLevels> levels_;
  sh::SphereSamples directions_;
  std::vector<Probe> probes_;
};

}  // namespace soffit::render

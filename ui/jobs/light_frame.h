// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/io/project/probes.h"
#include "core/light/direct_stage.h"
#include "core/light/emitter.h"
#include "core/relight/lighting.h"
#include "core/render/lit_probes.h"
#include "core/scene/scene.h"
#include "ui/jobs/held_sky.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soffit::ui {

/// Finished light of one state of the scene: what the viewport shows and the cursor reads.
/// Immutable once handed over.
struct LightFrame {
  std::shared_ptr<const relight::Solver> solver;  ///< whose texels the planes belong to
  relight::Planes lux;                            ///< RGB per slot, all luminaires
  std::vector<light::Emitter> emitters;           ///< scene-local, in the order of the luminaires
  std::vector<std::string> names;                 ///< of the luminaires
  /// What each luminaire gives the probes of the request, lux, and what shines in from outside
  /// after them where something does; empty for one on no lit surface.
  std::vector<std::vector<double>> shares;
  /// What shone in; null: nothing.
  std::shared_ptr<const daylight::Environment> outside;
  /// What specular surfaces reflect of this light; null: nothing does, or it is still to come.
  std::shared_ptr<const render::LitProbes> reflections;
  double reflections_ms = 0.0;  ///< of the light's milliseconds
  bool complete = true;  ///< false: what shines in from outside is still to come
  /// While a slider of the surroundings is held: what adds up to the light; null: `lux` is it.
  std::shared_ptr<const HeldSky> held;
  /// `lux` is that of an earlier step: it follows once the hand pauses. Goes with `held`.
  bool lux_late = false;
  std::uint64_t revision = 0;  ///< of the request that it answers
  relight::StageTimes times;   ///< of a move; zero otherwise
  light::DirectCounts counts;  ///< of a move; zero otherwise
  double milliseconds = 0.0;   ///< from taking up the request to the planes
};
using LightFramePtr = std::shared_ptr<const LightFrame>;

/// What is seen at a point of a surface.
struct SurfaceReading {
  dvec3 position{0.0};  ///< world
  vec3 normal{0.0F};    ///< unit, toward the eye
  std::uint32_t triangle = 0;
  double lux = 0.0;        ///< illuminance, as the texels around the point hold it
  double luminance = 0.0;  ///< cd/m^2 of the diffuse reflection
  std::string material;
};

/// The texels that hold the light at a probe: slots and weights of transfer::Texels::around().
struct ProbePlace {
  std::vector<std::uint32_t> slots;
  std::vector<float> weights;
};
/// Nothing where the probe's side of the building carries no light any more.
std::optional<ProbePlace> placeOf(const io::Probe& probe, const relight::Solver& solver);
std::optional<SurfaceReading> readProbe(const LightFrame& frame, const scene::Scene& scene,
                                        const io::Probe& probe);

/// The surface that a ray meets (scene-local, unit direction), front or back; nothing where it
/// meets none or only sides that carry no light.
std::optional<SurfaceReading> readSurface(const LightFrame& frame, const scene::Scene& scene,
                                          const geometry::Ray& ray);

}  // namespace soffit::ui

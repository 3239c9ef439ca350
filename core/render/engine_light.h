// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/relight/lighting.h"
#include "core/render/illumination.h"
#include "core/render/thrown_light.h"
#include "core/render/view_scene.h"

#include <memory>

namespace soffit::render {

/// The light engine's answer to a picture: direct light at every point asked for, indirect light
/// interpolated between the texels of the point's own surface, so that neither a wall nor an edge
/// lets any through. Points that may be blurred by more than their texel take direct light from the
/// texels, too.
class EngineLight : public Illumination {
 public:
  explicit EngineLight(const std::shared_ptr<const relight::Lighting>& lighting);

  /// For final pictures: specular surfaces throw their light where their lobes send it
  /// (thrown_light.h) instead of reflecting that much more of it diffusely; what they throw is
  /// reflected on like direct light. Without specular surfaces: the same as above, at no cost.
  /// scene: for the same scene and luminaires. Errors: cancelled.
  static Result<std::shared_ptr<const EngineLight>> withThrownLight(
      std::shared_ptr<const relight::Lighting> lighting, const ViewScene& scene,
      const ThrownLightOptions& options = {}, const Job& job = {});

  void evaluate(std::span<const SurfacePoint> points, std::span<vec3> direct,
                std::span<vec3> indirect) const override;

 private:
  EngineLight(std::shared_ptr<const relight::Lighting> lighting, relight::Planes indirect);
  void computeDirect(std::span<const SurfacePoint> points, std::span<vec3> direct) const;

  std::shared_ptr<const relight::Lighting> lighting_;
  relight::Planes indirect_;
  relight::Planes direct_;  ///< of the texels, the sky's left out
  struct Lamp {
    light::PreparedLight prepared;
    std::vector<light::MaskBlocker> bodies;
    vec3 weight;
  };
  std::vector<Lamp> lamps_;
};

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/lighting.h"
#include "core/render/illumination.h"

#include <memory>

namespace soffit::render {

/// The light engine's answer to a picture: direct light at every point asked for, indirect light
/// interpolated between the texels of the point's own surface, so that neither a wall nor an edge
/// lets any through.
class EngineLight : public Illumination {
 public:
  explicit EngineLight(std::shared_ptr<const relight::Lighting> lighting);

  void evaluate(std::span<const SurfacePoint> points, std::span<vec3> direct,
                std::span<vec3> indirect) const override;

 private:
  std::shared_ptr<const relight::Lighting> lighting_;
  relight::Planes indirect_;
  struct Lamp {
    light::PreparedLight prepared;
    std::vector<light::MaskBlocker> bodies;
    vec3 weight;
  };
  std::vector<Lamp> lamps_;
};

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#pragma once

#include "core/render/camera_frame.h"
#include "core/render/illumination.h"
#include "core/render/surface_sample.h"
#include "core/render/view_scene.h"

#include <cstdint>
#include <vector>

namespace soffit::design {

/// Some pixels of a picture and what their samples see.
struct PixelSamples {
  struct Pixel {
    int x = 0, y = 0;
    std::uint32_t begin = 0, end = 0;  ///< its samples on surfaces
    int rays = 0;                      ///< all of its samples
    std::uint32_t material = 0;        ///< of most samples that reflect
    bool reflects = false;
  };
  std::vector<Pixel> pixels;  ///< those without a luminaire in them
  std::vector<render::SurfaceSample> samples;

  [[nodiscard]] vec3 mean(const Pixel& pixel, const std::vector<vec3>& per_sample) const;
};

/// Every `stride`-th pixel both ways with `samples` rays of the reconstruction filter each.
PixelSamples samplePixels(const render::ViewScene& scene, const render::CameraFrame& frame,
                          int stride, int samples);

/// Diffuse radiance of each sample: albedo (E_direct + E_indirect) / pi.
std::vector<vec3> matteLight(const PixelSamples& pixels, const render::Illumination& illumination);

}  // namespace soffit::design

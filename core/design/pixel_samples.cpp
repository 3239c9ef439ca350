// SPDX-License-Identifier: MIT
#include "core/design/pixel_samples.h"

#include "core/render/first_hit.h"
#include "core/render/illumination_batch.h"
#include "core/render/pixel_pattern.h"

#include <algorithm>
#include <map>

namespace soffit::design {

vec3 PixelSamples::mean(const Pixel& pixel, const std::vector<vec3>& per_sample) const {
  vec3 sum(0.0F);
  for (std::uint32_t k = pixel.begin; k < pixel.end; ++k) sum += per_sample[k];
  return sum / static_cast<float>(std::max(pixel.rays, 1));
}

PixelSamples samplePixels(const render::ViewScene& scene, const render::CameraFrame& frame,
                          int stride, int samples) {
  const std::vector<vec2> pattern = render::pixelPattern(samples);
  PixelSamples all;
  std::vector<geometry::Ray> rays(pattern.size());
  std::vector<geometry::Hit> scratch(pattern.size());
  std::vector<render::FirstHit> first(pattern.size());
  for (int y = stride / 2; y < frame.height(); y += stride) {
    for (int x = stride / 2; x < frame.width(); x += stride) {
      for (std::size_t k = 0; k < pattern.size(); ++k) {
        rays[k] = frame.ray(x + 0.5 + static_cast<double>(pattern[k].x),
                            y + 0.5 + static_cast<double>(pattern[k].y));
      }
      render::traceFirst(scene, rays, {.coherent = true}, scratch, first);
      if (std::any_of(first.begin(), first.end(),
                      [](const render::FirstHit& hit) { return hit.emitter.valid(); })) {
        continue;
      }
      PixelSamples::Pixel pixel{.x = x, .y = y};
      pixel.begin = static_cast<std::uint32_t>(all.samples.size());
      pixel.rays = static_cast<int>(pattern.size());
      std::map<std::uint32_t, int> reflecting;
      for (std::size_t k = 0; k < pattern.size(); ++k) {
        if (!first[k].surface.valid()) continue;
        all.samples.push_back(
            render::sampleSurface(scene, rays[k], first[k].surface,
                                  {.spread = static_cast<float>(frame.pixelAngle()),
                                   .texture_share = render::textureShare(pattern.size())}));
        const render::SurfaceSample& sample = all.samples.back();
        if (scene.material(sample.point.triangle).f0 > 0.0F) ++reflecting[sample.material];
      }
      pixel.end = static_cast<std::uint32_t>(all.samples.size());
      int most = 0;
      for (const auto& [material, count] : reflecting) {
        if (count > most) {
          most = count;
          pixel.material = material;
        }
      }
      pixel.reflects = 2 * most > pixel.rays;
      all.pixels.push_back(pixel);
    }
  }
  return all;
}

std::vector<vec3> matteLight(const PixelSamples& pixels, const render::Illumination& illumination) {
  render::IlluminationBatch batch;
  std::vector<std::uint32_t> at;
  for (const render::SurfaceSample& s : pixels.samples) at.push_back(batch.add(s.point, s.surface));
  batch.run(illumination);
  std::vector<vec3> light;
  for (std::size_t k = 0; k < pixels.samples.size(); ++k) {
    light.push_back(pixels.samples[k].albedo * batch.total(at[k]) / static_cast<float>(kPi));
  }
  return light;
}

}  // namespace soffit::design

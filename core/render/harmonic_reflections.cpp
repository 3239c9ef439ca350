// SPDX-License-Identifier: MIT
#include "core/render/harmonic_reflections.h"

#include "core/glossy/bounces.h"
#include "core/glossy/lobe_shape.h"
#include "core/glossy/matrix_set.h"
#include "core/sh/index.h"

#include <array>

namespace soffit::render {

glossy::FloatBlocks arrivingAt(const ViewScene& scene, const SentAlbedo& sent,
                               const Illumination& illumination, std::span<const vec3> positions,
                               std::span<const vec3> normals,
                               const std::shared_ptr<const sh::SphereSamples>& directions,
                               int bands) {
  const auto light = [&](std::span<const geometry::Ray> rays, std::span<const geometry::Hit> hits,
                         std::span<vec3> radiance) {
    std::vector<SurfacePoint> points;
    std::vector<vec3> albedo;
    for (std::size_t k = 0; k < hits.size(); ++k) {
      const SurfaceSample seen = sampleSurface(scene, rays[k], hits[k], {.spread = 0.05F});
      points.push_back(seen.point);
      albedo.push_back(sent.of(seen));
    }
    std::vector<vec3> direct(points.size(), vec3(0.0F)), indirect(points.size(), vec3(0.0F));
    illumination.evaluate(points, direct, indirect);
    for (std::size_t k = 0; k < points.size(); ++k) {
      radiance[k] = albedo[k] * (direct[k] + indirect[k]) / static_cast<float>(kPi);
    }
  };
  const glossy::FirstHits first(scene.caster(), positions, normals, directions);
  return glossy::arrivingLight(first, light, bands);
}

std::vector<vec3> throughLobes(const ViewScene& scene, const glossy::FloatBlocks& arriving,
                               int bands, std::span<const SurfaceSample> samples,
                               std::span<const std::uint32_t> receiver_of) {
  // Every sample is a receiver that looks along its own lobe at its receiver's light.
  const std::size_t n = sh::coefficientCount(bands);
  const std::size_t stored = arriving.rows() / 3;
  glossy::FloatBlocks light(samples.size(), 3 * n);
  const glossy::LobeView none{vec3(0, 0, 1), 0.5F, 0.0F};
  std::array<std::vector<glossy::LobeView>, 2> lobes;  // both parts of the lobe
  for (auto& part : lobes) part.assign(samples.size(), none);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (receiver_of[k] == kNoReceiver) continue;
    for (std::size_t i = 0; i < 3 * n; ++i) {
      light.at(k, i) = arriving.at(receiver_of[k], i / n * stored + i % n);
    }
    const SurfaceSample& s = samples[k];
    const ViewMaterial& m = scene.material(s.point.triangle);
    const glossy::LobeShape shape =
        glossy::lobeShape(static_cast<double>(glm::dot(s.point.shading_normal, s.to_eye)),
                          static_cast<double>(s.alpha));
    const auto view = [&](const glossy::RoundLobe& lobe, double weight) {
      return glossy::LobeView{glossy::lobeAxis(lobe, s.point.shading_normal, s.to_eye),
                              static_cast<float>(lobe.alpha),
                              static_cast<float>(weight / lobe.above)};
    };
    lobes[0][k] = view(shape.base, static_cast<double>(m.f0) * shape.scale);
    lobes[1][k] = view(shape.rise, shape.bias);
  }
  std::vector<vec3> radiance(samples.size()), rise(samples.size());
  glossy::shade(light, lobes[0], radiance);
  glossy::shade(light, lobes[1], rise);
  for (std::size_t k = 0; k < rise.size(); ++k) {
    radiance[k] = glm::max(radiance[k] + rise[k], vec3(0.0F));
  }
  return radiance;
}

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#pragma once

#include "core/render/first_hit.h"
#include "core/render/illumination.h"
#include "core/render/illumination_batch.h"
#include "core/render/microfacet.h"
#include "core/render/render_options.h"
#include "core/render/sent_albedo.h"
#include "core/render/specular_layer.h"
#include "core/render/surface_sample.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace soffit::render {

/// A pixel whose surface reflects: its samples on that surface.
struct ReflectingPixel {
  int x = 0;
  int y = 0;
  std::span<const SurfaceSample> samples;  ///< at least one, all of one material
  /// Rays into a rough lobe: which part of the low-discrepancy set, of how many rays each.
  std::uint32_t part = 0;
  int rays = 0;
};

/// Memory of a Reflector, kept between tiles.
struct ReflectorScratch {
  /// A ray on its way and what it will bring to its first ray.
  struct Path {
    std::uint32_t target = 0;  ///< index in `radiance`
    vec3 throughput{1.0F};
    float pdf = 0.0F;     ///< sr^-1, times the rays of its lobe; 0: a mirror's
    float alpha = 0.0F;   ///< widest lobe on the way
    float spread = 0.0F;  ///< rad
    float footprint = 0.0F;
  };
  /// Diffuse light of a surface that a path met.
  struct Arrival {
    std::uint64_t cell = 0;
    std::uint32_t target = 0;
    vec3 factor{0.0F};
    SurfacePoint point;
    std::uint32_t surface = 0;
  };
  /// A shadow ray towards a luminaire and what it carries if nothing is in the way.
  struct Shadow {
    std::uint32_t target = 0;
    vec3 radiance{0.0F};
  };
  std::vector<geometry::Ray> rays, next_rays, shadow_rays;
  std::vector<Path> paths, next_paths;
  std::vector<geometry::Hit> hits;
  std::vector<FirstHit> first;
  std::vector<Arrival> arrivals;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  std::vector<std::uint32_t> speaker, light_of;  ///< per arrival
  std::vector<Shadow> shadows;
  std::vector<std::uint8_t> blocked;
  std::vector<vec3> radiance;            ///< per first ray
  std::vector<std::uint32_t> first_ray;  ///< per pixel and one past the last
  std::vector<ReflectingPixel> alone;    ///< samples as pixels of their own
  IlluminationBatch batch;
};

/// Light that specular surfaces reflect towards the eye.
///
/// Rough lobes are sampled twice and combined by the balance heuristic (Veach 1997, ch. 9): rays by
/// the visible normals, which carry surfaces and luminaires, and one shadow ray per luminaire.
/// Mirrors send a ray per sample of the pixel. Surfaces seen in a reflection show their diffuse
/// light, evaluated once per cell of about the size that the reflection resolves, and their own
/// lobe, which is taken no narrower than the one it is seen through (Kaplanyan & Dachsbacher 2013,
/// "Path Space Regularization": a lamp in a mirror in a dull floor would be nothing but noise).
/// Where the last reflection ends, a rough lobe's light is taken as reflected diffusely
/// (SentAlbedo).
class Reflector {
 public:
  Reflector(const ViewScene& scene, const Illumination& illumination, const RenderOptions& options,
            float pixel_angle)
      : scene_(scene),
        illumination_(illumination),
        options_(options),
        pixel_angle_(pixel_angle),
        sent_(scene) {}

  /// Writes the pixels of the layer: each traces its part of the set of a block (specular_layer.h).
  void render(std::span<ReflectingPixel> pixels, ReflectorScratch& scratch,
              SpecularLayer& layer) const;

  /// Writes pixels of the layer that each trace the whole set of a block, spread over all their
  /// samples (of any materials that reflect), and aim at luminaires from every sample: for surfaces
  /// so curved that the pixels of a block have not one lobe. Leaves coverage as it is.
  void renderWhole(std::span<const ReflectingPixel> pixels, ReflectorScratch& scratch,
                   SpecularLayer& layer) const;

 private:
  /// A lobe that light is gathered through.
  struct Lobe {
    const SurfaceSample& at;
    float f0, alpha;
    float rays;            ///< that sample it
    vec3 throughput;       ///< of what it reflects
    std::uint32_t target;  ///< that it is added to
  };
  void follow(std::span<const ReflectingPixel> pixels, ReflectorScratch& s) const;
  void spawn(const ReflectingPixel& pixel, ReflectorScratch& s) const;
  /// u_of(i) gives the point of the unit square for luminaire i.
  template <class Points>
  void aimAtLuminaires(const Lobe& lobe, const Points& u_of, ReflectorScratch& s) const;
  void traceShadows(ReflectorScratch& s) const;
  void traceWave(ReflectorScratch& s, bool last) const;
  void meetEmitter(std::size_t i, ReflectorScratch& s) const;
  void meetSurface(std::size_t i, bool last, ReflectorScratch& s) const;
  void lightArrivals(ReflectorScratch& s) const;
  [[nodiscard]] int rayCount(const ViewMaterial& material) const;

  const ViewScene& scene_;
  const Illumination& illumination_;
  const RenderOptions& options_;
  float pixel_angle_;
  SentAlbedo sent_;
};

}  // namespace soffit::render

// SPDX-License-Identifier: MIT
#pragma once

#include "core/render/camera_frame.h"
#include "core/render/film.h"
#include "core/render/first_hit.h"
#include "core/render/illumination_batch.h"
#include "core/render/quick_reflections.h"
#include "core/render/reflector.h"
#include "core/render/render_options.h"

#include <span>
#include <vector>

namespace soffit::render {

/// A pixel to be rendered, and how.
struct PixelTask {
  int x = 0;
  int y = 0;
  bool share = true;  ///< samples that see the same place share one evaluation of the light
};

/// Memory of a TileRenderer, kept between tiles.
struct TileScratch {
  /// Samples of one pixel that see the same place.
  struct Group {
    std::uint32_t first = 0;  ///< the sample that stands for all: once listed, the middle one
    std::uint32_t count = 0;
    vec3 normals{0.0F};       ///< sum of the shading normals
    vec2 offsets{0.0F};       ///< sum of where in the pixel they are
    std::uint32_t light = 0;  ///< index in `batch`
  };
  std::vector<geometry::Ray> rays;
  std::vector<geometry::Hit> hits;
  std::vector<FirstHit> first;
  std::vector<SurfaceSample> samples;   ///< per ray; where a surface was met
  std::vector<std::uint32_t> group_of;  ///< per ray
  std::vector<Group> groups;
  std::vector<std::uint32_t> first_group;  ///< per pixel and one past the last
  std::vector<SurfaceSample> mirror_samples;
  std::vector<std::uint32_t> mirror_counts;
  std::vector<ReflectingPixel> mirrors, rough;
  std::vector<PixelTask> tasks;
  std::size_t central = 0;  ///< the sample of a pixel that is nearest to its centre
  IlluminationBatch batch;
  ReflectorScratch reflector;
};

/// Renders a handful of pixels at once: rays, light, film. Stateless but for its scratch.
class TileRenderer {
 public:
  /// quick: what rough reflections come from instead of rays; null for rays.
  TileRenderer(const ViewScene& scene, const CameraFrame& camera, const Illumination& illumination,
               const RenderOptions& options, const QuickReflections* quick = nullptr);

  /// Renders the pixels with the samples of a pattern (pixelPattern()). Writes the film's pixels;
  /// and the layer's, unless it is null or has no pixels.
  void render(std::span<const PixelTask> tasks, std::span<const vec2> pattern, TileScratch& scratch,
              Film& film, SpecularLayer* layer) const;

  /// Traces the reflections of pixels anew, each by the whole set of a block (standsAlone()) and
  /// all of its samples. Writes the layer's pixels.
  void reflectWhole(std::span<const PixelTask> tasks, std::span<const vec2> pattern,
                    TileScratch& scratch, SpecularLayer& layer) const;

 private:
  void trace(std::span<const PixelTask> tasks, std::span<const vec2> pattern, TileScratch& s) const;
  [[nodiscard]] bool mayShowLuminaires(std::span<const PixelTask> tasks) const;
  [[nodiscard]] bool sameAsBefore(std::size_t i, const TileScratch& s) const;
  void groupSamples(std::span<const PixelTask> tasks, std::span<const vec2> pattern,
                    TileScratch& s) const;
  void chooseMiddle(std::size_t first_group, std::size_t begin, std::span<const vec2> pattern,
                    const SurfaceOptions& how, TileScratch& s) const;
  void resolve(const PixelTask& task, std::size_t pixel, std::size_t per_pixel,
               const TileScratch& s, Film& film) const;
  void listMirrors(TileScratch& s) const;
  void reflect(std::span<const PixelTask> tasks, std::size_t per_pixel, TileScratch& s,
               const Film& film, SpecularLayer& layer) const;

  const ViewScene& scene_;
  const CameraFrame& camera_;
  const RenderOptions& options_;
  const Illumination& illumination_;
  Reflector reflector_;
  const QuickReflections* quick_;
  std::vector<vec4> luminaires_;  ///< where they can be in the picture: left, top, right, bottom
};

}  // namespace soffit::render

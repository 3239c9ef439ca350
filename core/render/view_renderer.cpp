// SPDX-License-Identifier: MIT
#include "core/render/view_renderer.h"

#include "core/base/parallel.h"
#include "core/color/luminance.h"
#include "core/render/pixel_pattern.h"
#include "core/render/tile_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

namespace soffit::render {
namespace {

constexpr int kBaseSamples = 4;
constexpr int kMaxSamples = 1024;
/// A highlight on a curved surface changes within a pixel: at least so many places reflect.
constexpr int kWholeSamples = 16;

/// A step of illuminance between neighbours on one surface that is a shadow's edge: its share of
/// the brighter one, and of the picture's mean, below which nobody sees it.
constexpr float kEdgeStep = 0.06F;
constexpr float kDarkShare = 0.02F;

/// Lends scratch memory to whoever works on a tile. Not thread-local: an illumination that runs
/// loops of its own may start another tile on a thread that waits inside one.
class ScratchPool {
 public:
  std::unique_ptr<TileScratch> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::make_unique<TileScratch>();
    auto scratch = std::move(free_.back());
    free_.pop_back();
    return scratch;
  }
  void giveBack(std::unique_ptr<TileScratch> scratch) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(scratch));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<TileScratch>> free_;
};

struct Tile {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

std::vector<Tile> tilesOf(const RenderOptions& options) {
  std::vector<Tile> tiles;
  const int side = std::clamp(options.tile, 4, 256);
  for (int y = 0; y < options.height; y += side) {
    for (int x = 0; x < options.width; x += side) {
      tiles.push_back(
          {x, y, std::min(x + side, options.width), std::min(y + side, options.height)});
    }
  }
  return tiles;
}

/// All pixels of a tile in blocks of 2 x 2: four samples each fill a packet of 16 rays.
void listPixels(const Tile& tile, std::vector<PixelTask>& tasks) {
  tasks.clear();
  for (int y = tile.y0; y < tile.y1; y += 2) {
    for (int x = tile.x0; x < tile.x1; x += 2) {
      for (int j = y; j < std::min(y + 2, tile.y1); ++j)
        for (int i = x; i < std::min(x + 2, tile.x1); ++i) tasks.push_back({i, j, true});
    }
  }
}

/// What the first pass leaves for the second.
class EdgeFinder {
 public:
  EdgeFinder(const ViewScene& scene, const Film& film, const std::vector<std::uint8_t>& mixed)
      : scene_(scene), film_(film), mixed_(mixed) {
    double sum = 0.0;
    for (const float lux : film.lux) sum += static_cast<double>(lux);
    floor_ = kDarkShare *
             static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(film.count(), 1)));
  }

  /// A step of light towards one of the four neighbours on the same surface.
  [[nodiscard]] bool shadowEdge(int x, int y) const {
    return step(x, y, x - 1, y) || step(x, y, x + 1, y) || step(x, y, x, y - 1) ||
           step(x, y, x, y + 1);
  }
  /// Samples that saw different places, here or next door: the filter reaches into the neighbours.
  [[nodiscard]] bool mixed(int x, int y) const {
    const std::uint32_t own = surfaceAt(x, y);
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, film_.height - 1); ++j) {
      for (int i = std::max(x - 1, 0); i <= std::min(x + 1, film_.width - 1); ++i) {
        if (mixed_[film_.at(i, j)] != 0 || surfaceAt(i, j) != own) return true;
      }
    }
    return false;
  }

 private:
  [[nodiscard]] std::uint32_t surfaceAt(int x, int y) const {
    const std::uint32_t triangle = film_.triangle[film_.at(x, y)];
    return triangle == geometry::kNoTriangle ? triangle : scene_.surface(triangle);
  }
  [[nodiscard]] bool step(int x, int y, int i, int j) const {
    if (i < 0 || j < 0 || i >= film_.width || j >= film_.height) return false;
    const std::uint32_t surface = surfaceAt(x, y);
    if (surface == geometry::kNoTriangle || surface != surfaceAt(i, j)) return false;
    const float here = film_.lux[film_.at(x, y)];
    const float there = film_.lux[film_.at(i, j)];
    return std::abs(here - there) > kEdgeStep * std::max(here, there) + floor_;
  }
  const ViewScene& scene_;
  const Film& film_;
  const std::vector<std::uint8_t>& mixed_;
  float floor_ = 0.0F;
};

/// One render's working state.
struct Run {
  const ViewScene& scene;
  const TileRenderer& renderer;
  const RenderOptions& options;
  const Job& job;
  std::vector<Tile> tiles;
  ScratchPool pool;

  /// body(tile, scratch) for every tile, until cancelled.
  template <class Body>
  void forTiles(const char* stage, const Body& body) {
    std::atomic<std::size_t> done{0};
    parallelFor(tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
        auto scratch = pool.take();
        body(tiles[i], *scratch);
        pool.giveBack(std::move(scratch));
        job.report(stage, static_cast<double>(++done) / static_cast<double>(tiles.size()));
      }
    });
  }
};

/// A number for what a sample sees: a surface, a luminaire or nothing.
std::uint64_t placeOf(const ViewScene& scene, const FirstHit& hit) {
  if (hit.emitter.valid()) return 0x100000000U + static_cast<std::uint64_t>(hit.emitter.emitter);
  return hit.surface.valid() ? scene.surface(hit.surface.triangle) : ~std::uint64_t{0};
}

/// What the samples of a pixel saw: different places, or one place with a texture on it.
constexpr std::uint8_t kPlaces = 1;
constexpr std::uint8_t kTexture = 2;

/// Whether a texture varies between the samples of a pixel by more than what nobody sees.
bool patterned(std::span<const FirstHit> hits, std::span<const SurfaceSample> seen) {
  constexpr float kContrast = 0.1F;
  float low = std::numeric_limits<float>::infinity();
  float high = 0.0F;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (!hits[k].surface.valid()) continue;
    const float albedo = color::luminance(seen[k].albedo);
    low = std::min(low, albedo);
    high = std::max(high, albedo);
  }
  return high - low > kContrast * high;
}

void firstPass(Run& run, Film& film, SpecularLayer& layer, std::vector<std::uint8_t>& mixed) {
  const auto pattern = pixelPattern(std::min(run.options.samples, kBaseSamples));
  run.forTiles("rendering", [&](const Tile& tile, TileScratch& scratch) {
    listPixels(tile, scratch.tasks);
    run.renderer.render(scratch.tasks, pattern, scratch, film, &layer);
    for (std::size_t i = 0; i < scratch.tasks.size(); ++i) {
      const std::size_t at = film.at(scratch.tasks[i].x, scratch.tasks[i].y);
      const auto samples = std::span(scratch.first).subspan(i * pattern.size(), pattern.size());
      const bool several = std::any_of(samples.begin(), samples.end(), [&](const FirstHit& hit) {
        return placeOf(run.scene, hit) != placeOf(run.scene, samples.front());
      });
      const auto seen = std::span(scratch.samples).subspan(i * pattern.size(), pattern.size());
      mixed[at] = several ? kPlaces : patterned(samples, seen) ? kTexture : 0;
    }
  });
}

void secondPass(Run& run, Film& film, const std::vector<std::uint8_t>& mixed) {
  const auto pattern = pixelPattern(run.options.samples);
  const Film before = film;
  const EdgeFinder edges(run.scene, before, mixed);
  const bool more = run.options.samples > kBaseSamples;
  run.forTiles("refining edges", [&](const Tile& tile, TileScratch& scratch) {
    scratch.tasks.clear();
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        const bool shadow = edges.shadowEdge(x, y);
        if (shadow || (more && edges.mixed(x, y))) scratch.tasks.push_back({x, y, !shadow});
      }
    }
    if (!scratch.tasks.empty()) run.renderer.render(scratch.tasks, pattern, scratch, film, nullptr);
  });
}

/// Reflections of pixels that cannot share theirs with a block: curved surfaces, the edges of
/// surfaces, and of shadows, across which a highlight may break off.
void reflectionPass(Run& run, const Film& film, const std::vector<std::uint8_t>& mixed,
                    SpecularLayer& layer) {
  const auto pattern = pixelPattern(std::max(run.options.samples, kWholeSamples));
  const EdgeFinder edges(run.scene, film, mixed);
  constexpr int kReach = kPhases / 2;
  std::vector<std::uint8_t> alone(film.count(), 0);
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const bool several = mixed[film.at(x, y)] == kPlaces && smooths(layer, x, y);
      if (several || standsAlone(layer, x, y)) alone[film.at(x, y)] = 1;
      if (layer.pixels[film.at(x, y)].coverage <= 0.0F || !edges.shadowEdge(x, y)) continue;
      for (int j = std::max(y - kReach, 0); j <= std::min(y + kReach, film.height - 1); ++j) {
        for (int i = std::max(x - kReach, 0); i <= std::min(x + kReach, film.width - 1); ++i) {
          if (smooths(layer, i, j)) alone[film.at(i, j)] = 1;
        }
      }
    }
  }
  if (std::none_of(alone.begin(), alone.end(), [](std::uint8_t a) { return a != 0; })) return;
  run.forTiles("refining reflections", [&](const Tile& tile, TileScratch& scratch) {
    scratch.tasks.clear();
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        if (alone[film.at(x, y)] != 0) scratch.tasks.push_back({x, y, true});
      }
    }
    if (!scratch.tasks.empty()) run.renderer.reflectWhole(scratch.tasks, pattern, scratch, layer);
  });
}

}  // namespace

Result<Film> renderView(const ViewScene& scene, const scene::Camera& camera,
                        const Illumination& illumination, const RenderOptions& options,
                        const Job& job) {
  const auto frame =
      CameraFrame::create(camera, options.width, options.height, scene.mesh().origin);
  if (!frame) return frame.error();
  if (options.samples < 1 || options.samples > kMaxSamples) {
    return Error{"samples",
                 fmt::format("expected 1 to {} per pixel, found {}", kMaxSamples, options.samples),
                 "4 is a good number, 16 for print."};
  }
  Film film(options.width, options.height);
  SpecularLayer layer{options.width, options.height, {}};
  const Reflections method = settled(options.reflections, options.quick);
  const bool reflections = options.quantity == Quantity::luminance && options.max_reflections > 0 &&
                           method != Reflections::none;
  if (reflections && scene.hasSpecular()) layer.pixels.resize(film.count());
  std::vector<std::uint8_t> mixed(film.count(), 0);
  std::optional<QuickReflections> quick;
  if (!layer.pixels.empty() && method != Reflections::rays) {
    quick.emplace(scene, illumination, method);
  }
  const TileRenderer renderer(scene, *frame, illumination, options, quick ? &*quick : nullptr);
  Run run{scene, renderer, options, job, tilesOf(options), {}};
  firstPass(run, film, layer, mixed);
  if (options.samples > 1) secondPass(run, film, mixed);
  if (!layer.pixels.empty()) reflectionPass(run, film, mixed, layer);
  if (job.cancelled()) return Error{"", "rendering was cancelled", ""};
  addReflections(layer, film);
  return film;
}

}  // namespace soffit::render
